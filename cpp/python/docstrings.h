// Texts of help(_swept): shapes, dtypes, units, errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace swept::python {

constexpr const char* kModuleDoc =
    R"(Envelopes of moving bodies: numpy arrays in and out, lengths in mm, times in s.

Long calls release the interpreter's lock; watch and cancel them from another thread through a
RunContext. Ctrl-C cancels as well. Failures raise Error or one of its subclasses.)";

constexpr const char* kRunContextDoc =
    R"(RunContext(threads=0, memory_limit_mb=0)

Watches and cancels one run from any thread. threads (up to 4096) 0: all cores; memory_limit_mb 0:
three quarters of what is free. Use one for one run: progress does not start over.)";

constexpr const char* kMeshDoc =
    "Triangles: vertices float64 (N, 3) in mm, triangles int32 (M, 3), both read-only views.";

constexpr const char* kResultDoc =
    R"(Result of compute(): mesh (Mesh), report (dict), contact_time, feature_edges, sources (Sources or
None).
The arrays are read-only views that share the result's memory; copy them to change them.)";

inline constexpr const char* kSourcesDoc =
    R"(What made each triangle of an envelope. Arrays by triangle, copied at each call.

A cap is a face of the body as it lies at one pose. An edge was swept by an edge of the body, where two
faces meet at 8 degrees or more. A graze was swept by the inside of a face that the sweep touches along a
curve, by a face that slides along itself, or by two faces that meet smoothly. Faces are those given as faces, else triangles of the body.
Of a simplified envelope: what made the largest part of the triangle's area.)";

constexpr const char* kRecutDoc =
    R"(recut(tolerance, run=None) -> Result

The same envelope simplified to another tolerance (mm, up to 1e9; 0: not at all) without
sampling again. Only for a result that was computed with a tolerance above 0: else InvalidInput.
This result stays as it is. Of the report, check and simplification_deviation change.)";

constexpr const char* kComputeDoc =
    R"(compute(vertices, triangles, motion, interpolation='linear', run=None, faces=None, **options) -> Result

Envelope of a body moved along a trajectory.

vertices   float (N, 3), mm
triangles  int (M, 3), counter-clockwise seen from outside
motion     one of
             (times (K,) s, quaternions (K, 4) in the order x, y, z, w, translations (K, 3) mm)
             the same and a pivot (3,), mm: the point of the body that moves straight between two poses
               where the interpolation is linear, in the body's coordinates; else its origin does
             (times (K,) s, matrices (K, 4, 4))
             matrices (K, 4, 4), at the times 0, 1, 2, ...
           x_world = R x + t
interpolation  'none' (union of posed copies), 'linear' (lerp + slerp) or 'screw'
run        RunContext to watch and cancel
faces      int (M,): number (0 or more) of the face that each triangle is a piece of; for sources

Options: resolution=128 (cells along the longest side) or cell=0.0 (mm); components='consistent'
('dc', 'dmc', 'equivalence', 'greedy'); backend='auto' ('cpu', 'gpu'); keep_cavities=False; cull=True;
tolerance=0.0 (mm, simplification); offset=0.0 (mm); conservative=False; position_filter=0.0 (mm);
chord=0.02 (cells); weld=1e-6 (of the box diagonal); sources=False (Result.sources: what made each
triangle; neither with an offset nor conservative); threads=0; memory_limit_mb=0.

Raises Error with .status, .code and .report: InvalidInput, ResourceLimit, OutOfMemory, Cancelled,
DeviceUnavailable, DeviceLost, InternalError. Wrong shapes raise ValueError, wrong types TypeError.)";

inline constexpr const char* kWarmMemoryDoc =
    R"(Memory whose pages are fetched before a large copy in this thread, which then takes a third of the time.

WarmMemory(bytes) reserves it, touch() fetches the pages (any thread), release() just before the copy. Keep
the object until the copy is made. Does nothing for less than 8 MiB, or without the GNU C library.)";

constexpr const char* kPreviewSessionDoc =
    R"(PreviewSession(vertices, triangles, faces=None, **options)

Quick, coarse envelopes of one body while its motion is edited: the checked body stays warm between
calls. Options as those of compute(), for all calls; chord is at least 0.1, tolerance is left out.)";

constexpr const char* kPreviewDoc =
    R"(compute(motion, interpolation='linear', run=None, sketch=False) -> Result

Arguments, result and errors as those of the module's compute(). From one thread at a time. sketch:
the surface alone, neither mended nor checked (finding NotChecked), in half the time; to be drawn.)";

constexpr const char* kEstimateDoc =
    R"(estimate(vertices, triangles, motion, interpolation='linear', trial=False, run=None, **options)
-> dict

What compute() would take: grid (3 ints), cell (mm), memory_bytes, seconds, triangles, and
useful_filter (mm) where a position filter would leave out most poses without changing more than the
chord does. From boxes, in milliseconds; with trial after sampling some steps, which takes up to a
second. Arguments and errors as those of compute().)";

constexpr const char* kCheckMeshDoc =
    R"(check_mesh(vertices, triangles, run=None) -> dict

Checks a mesh: passes, vertices, triangles, shells, finite, closed, manifold, oriented, open_edges,
non_manifold_edges, non_manifold_vertices, misoriented_edges, degenerate_triangles, unused_vertices,
self_intersections, first_intersections, volume (mm^3), area (mm^2).)";

constexpr const char* kReadMeshDoc =
    R"(read_mesh(path, unit='mm') -> Mesh

Reads PLY, STL, OBJ or OFF. unit: of the numbers in the file: mm, cm, m, in. Raises InvalidInput
(code BadFile) with the place of what is wrong.)";

constexpr const char* kReadBodyDoc =
    R"(read_body(path, unit='mm', tolerance=None, cell=None, resolution=128, run=None, angle=0.2)
-> Mesh

Reads a moving part: PLY, STL, OBJ or OFF as read_mesh(), or all solids of a STEP or BREP file as one
body, tessellated within tolerance (mm), else within 0.02 of cell (mm), else within 0.02 of the
smallest cell that resolution can give for such a body; angle: rad between neighbouring triangles.
Mesh.chord_error and Mesh.findings say how.)";

constexpr const char* kReadPartsDoc =
    R"(read_parts(path, unit='mm', chord_error=0.0, deflection=0.05, run=None) -> [(name, Mesh), ...]

Reads parts that keep their names: a mesh file is one, named after the file; of a STEP or BREP file each
solid is one, named after its product and tessellated within deflection (mm). chord_error: mm, how far a
mesh file leaves its exact surface. Raises InvalidInput, Cancelled.)";

constexpr const char* kWriteMeshDoc =
    R"(write_mesh(path, vertices, triangles, no_clobber=False)

Writes PLY (double precision), STL, OBJ, OFF or 3MF (single precision), in mm. An existing file is
replaced only when the new one is complete; with no_clobber it is refused. Raises ExportFailed.)";

constexpr const char* kReadTrajectoryDoc =
    R"(read_trajectory_csv(path, unit='mm') -> (times (K,), quaternions (K, 4), translations (K, 3))

Reads t,tx,ty,tz,qx,qy,qz,qw or 16 matrix numbers a row; comma, semicolon or tab; plain, gzip or xz.
times in s, quaternions x, y, z, w, translations in mm. Raises InvalidInput (code BadFile,
EmptyTrajectory, NotRigid, BadPose) with line and column.)";

constexpr const char* kWriteSolidDoc =
    R"(write_solid(path, vertices, triangles, run=None, no_clobber=False, **options) -> dict

Closed mesh -> solid in a STEP (.step, .stp) or BREP (.brep, .brp) file, read back and checked before
it replaces an old one, which no_clobber refuses. Returns the key "solid" of the program's reports,
and warnings. Raises ExportFailed, Cancelled.

Options: tolerance (mm, 0: exact, unless a limit asks for more), recognise=True, max_faces=20000,
max_megabytes=0 (no limit), merge_coplanar=True, planar_tolerance=1e-6 (mm), schema='ap214',
'ap242' or 'ap242-tessellated' (the triangles as they are, no tolerance), product_name='Swept
envelope', author, organization, colour=(r, g, b), exact=False, strict=False. Without a tolerance the
solid gets the smallest one that meets the limits; with exact it is refused instead. strict refuses
a solid farther from the mesh than the tolerance.)";

constexpr const char* kEstimateSolidDoc =
    R"(estimate_solid(vertices, triangles, run=None, **options) -> dict

What write_solid with the same options would take: triangles, faces (an upper bound), megabytes,
seconds. Raises ExportFailed where no solid can be made of the mesh.)";

}  // namespace swept::python
