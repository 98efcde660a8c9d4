// Texts of help(_swept), with shapes, dtypes, units and errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace swept::python {

constexpr const char* kModuleDoc =
    R"(Computes envelopes of moving bodies. Input and output are numpy arrays, with lengths in mm and times in s.

Long calls release the interpreter lock. Use a RunContext to watch or cancel a call from another
thread; Ctrl-C cancels it as well. A call that fails raises Error or one of its subclasses.)";

constexpr const char* kRunContextDoc =
    R"(RunContext(threads=None, memory_limit_mb=None)

Watches and cancels one run, from any thread. threads: 1 to 4096, or None for all cores.
memory_limit_mb: None means three quarters of the free memory. Create a new RunContext for each run,
because its progress does not return to 0.)";

constexpr const char* kMeshDoc =
    "A triangle mesh: vertices float64 (N, 3) in mm, and triangles int32 (M, 3), as read-only "
    "views.";

constexpr const char* kResultDoc =
    R"(The result of compute(): mesh (Mesh), report (dict), contact_time, feature_edges, and sources
(Sources or None).
The arrays are read-only views that share memory with the result. Copy an array to change it.)";

inline constexpr const char* kSourcesDoc =
    R"(What made each triangle of an envelope. Each property returns a new array with one row for each triangle.

Kinds: a "cap" is a face of the body in its place at one pose. An "edge" was swept by an edge of the
body, where two faces meet at 8 degrees or more. A "graze" was swept by the inside of a face that
touches the envelope along a curve, by a face that slides along itself, or by two faces that meet smoothly.
Faces are numbered as in the argument faces of compute(). Without it, each triangle of the body is a face.
If the envelope was simplified, a row describes what made the largest part of the area of the triangle.)";

constexpr const char* kRecutDoc =
    R"(recut(tolerance, run=None) -> Result

Returns the same envelope, simplified to another tolerance (mm, up to 1e9; 0: not simplified), without
sampling it again. Raises InvalidInput if this result was computed with tolerance 0.
This result does not change. The new report differs only in check and simplification_deviation.)";

constexpr const char* kComputeDoc =
    R"(compute(vertices, triangles, motion, interpolation='linear', run=None, faces=None, **options) -> Result

Computes the envelope of a body that moves along a trajectory.

vertices   float (N, 3), mm
triangles  int (M, 3), counter-clockwise seen from outside
motion     one of
             (times (K,) s, quaternions (K, 4) in the order x, y, z, w, translations (K, 3) mm)
             the same three and a pivot (3,), mm, in coordinates of the body: the point that moves in a
               straight line between two poses if the interpolation is linear (default: the origin)
             (times (K,) s, matrices (K, 4, 4))
             matrices (K, 4, 4), at the times 0, 1, 2, ...
           x_world = R x + t
interpolation  'none' (union of the body at all poses), 'linear' (lerp + slerp) or 'screw'
run        RunContext to watch and cancel the run
faces      int (M,): for each triangle, the index (from 0) of the face to which it belongs; used by sources

Options: resolution=128 (cells along the longest side) or cell=None (mm); components='consistent'
('dc', 'dmc', 'equivalence', 'greedy'); backend='auto' ('cpu', 'gpu'); keep_cavities=False; cull=True;
tolerance=0.0 (mm, simplification); offset=0.0 (mm); conservative=False; position_filter=0.0 (mm);
chord_tolerance=None (mm; None: 0.02 of a cell); weld_tolerance=None (mm; None: 1e-6 of the box
diagonal); sources=False (True: record in Result.sources what made each triangle; not allowed with an
offset or with conservative); threads=None; memory_limit_mb=None.

Raises a subclass of Error, with .status, .code and .report: InvalidInput, ResourceLimit, OutOfMemory,
Cancelled, DeviceUnavailable, DeviceLost, InternalError. Raises ValueError if an array has a wrong shape,
and TypeError if an argument has a wrong type.)";

inline constexpr const char* kWarmMemoryDoc =
    R"(Reserves memory and fetches its pages before a large copy, which then takes a third of the time.

Use: WarmMemory(bytes) reserves the memory. touch() fetches its pages and may run in any thread. release(),
in the thread that created the object, gives the memory back to the heap directly before the copy. Keep the
object until the copy is made. Has no effect below 8 MiB, or without the GNU C library.)";

constexpr const char* kPreviewSessionDoc =
    R"(PreviewSession(vertices, triangles, faces=None, **options)

Computes quick, coarse envelopes of one body while its motion is edited. The session checks the body once
and keeps the result for all calls. The options are those of compute() and hold for all calls, but the
chord tolerance is at least 0.1 of a cell, and tolerance is ignored.)";

constexpr const char* kPreviewDoc =
    R"(compute(motion, interpolation='linear', run=None, sketch=False) -> Result

Arguments, result and errors are those of compute() of the module. Only one thread may call it at a time.
sketch=True computes only the surface and neither repairs nor checks it (finding NotChecked). This takes
half the time and is meant for display.)";

constexpr const char* kEstimateDoc =
    R"(estimate(vertices, triangles, motion, interpolation='linear', trial=False, run=None, **options)
-> dict

Estimates the effort of compute() with the same arguments. Returns grid (3 ints), cell (mm), memory_bytes,
seconds and triangles. Also returns useful_filter (mm) if a position filter would skip most poses and
change the envelope by no more than the chord error. With trial=False the estimate uses only bounding boxes
and takes milliseconds; with trial=True it samples some motion steps and takes up to a second.
Raises the same errors as compute().)";

constexpr const char* kCheckMeshDoc =
    R"(check_mesh(vertices, triangles, run=None) -> dict

Checks a mesh and returns passes, vertices, triangles, shells, finite, closed, manifold, oriented, open_edges,
non_manifold_edges, non_manifold_vertices, misoriented_edges, degenerate_triangles, unused_vertices,
self_intersections, first_intersections, volume (mm^3) and area (mm^2).)";

constexpr const char* kReadMeshDoc =
    R"(read_mesh(path, unit='mm') -> Mesh

Reads a PLY, STL, OBJ or OFF file. unit: the unit of the numbers in the file (mm, cm, m or in). Raises
InvalidInput (code BadFile); its message says where the fault is.)";

constexpr const char* kReadBodyDoc =
    R"(read_body(path, unit='mm', tolerance=None, cell=None, resolution=128, run=None, angle=0.2,
reader=None) -> Mesh

Reads a moving part: a PLY, STL, OBJ or OFF file, as read_mesh() does, or all solids of a STEP or BREP file
as one body. The triangles of a solid deviate from it by at most tolerance (mm). If tolerance is None,
0.02 of cell (mm) is used; if cell is None too, 0.02 of the smallest cell that resolution can give for
such a body. angle: largest angle (rad) between adjacent triangles of a curved face.
Mesh.chord_error and Mesh.findings describe the result.

reader: a function that reads STEP and BREP files in place of the module's own OpenCASCADE. It takes the path,
the linear deflection (mm) and the angular deflection (rad), and returns (name, vertices, triangles, faces) for
each solid, in mm. faces has the index of its face for each triangle, or is None. Mesh.shape is then None. A
module without OpenCASCADE needs a reader for such files.)";

constexpr const char* kReadPartsDoc =
    R"(read_parts(path, unit='mm', chord_error=0.0, deflection=0.05, run=None, reader=None)
-> [(name, Mesh), ...]

Reads parts with their names. A mesh file is one part with the name of the file. In a STEP or BREP file,
each solid is a part with the name of its product; its triangles deviate from it by at most deflection (mm).
chord_error: how far (mm) the triangles of a mesh file deviate from the exact surface. reader: as for
read_body(). Raises InvalidInput, Cancelled.)";

constexpr const char* kWriteMeshDoc =
    R"(write_mesh(path, vertices, triangles, no_clobber=False)

Writes a PLY, OBJ, OFF or 3MF file (double precision) or an STL file (single precision), in mm. Replaces an
existing file only after the new file is complete. With no_clobber=True, an existing file is never
replaced. Raises ExportFailed.)";

constexpr const char* kReadTrajectoryDoc =
    R"(read_trajectory_csv(path, unit='mm') -> (times (K,), quaternions (K, 4), translations (K, 3))

Reads a table of poses. Each row holds t,tx,ty,tz,qx,qy,qz,qw, or the 12, 16 or 17 numbers of a matrix, separated
by commas, semicolons or tabs. The file may be compressed with gzip or xz. Returns times in s, quaternions in
the order x, y, z, w, and translations in mm. Raises InvalidInput (code BadFile, EmptyTrajectory, NotRigid
or BadPose); its message names line and column.)";

constexpr const char* kWriteSolidDoc =
    R"(write_solid(path, vertices, triangles, run=None, no_clobber=False, reader=None, **options) -> dict

Converts a closed mesh to a solid and writes it as a STEP (.step, .stp) or BREP (.brep, .brp) file. The new
file is read back and checked before it replaces an existing one; with no_clobber=True, an existing file
is never replaced. Returns the contents of the key "solid" in the program's reports, and warnings. Raises
ExportFailed, Cancelled.

Options: tolerance (mm; 0: exact, unless a limit requires a tolerance), recognise=True, max_faces=20000,
max_megabytes=None (no limit), merge_coplanar=True, planar_tolerance=1e-6 (mm), schema='ap214',
'ap242' or 'ap242-tessellated' (writes the triangles unchanged; allows no tolerance), product_name='Swept
envelope', author, organization, colour=(r, g, b), exact=False, strict=False. If tolerance is 0 and the
solid exceeds a limit, the smallest tolerance that meets the limits is used; with exact=True, the solid is
refused instead. strict=True refuses a solid that deviates from the mesh by more than the tolerance.

reader: a function that checks the new file in place of the module's own OpenCASCADE, for STEP files only. It
takes the text of the file (bytes), and returns a dict with solids, shells, faces and edges (counts), valid,
complaint (text, empty if valid), volume (mm^3), edge_tolerance (mm, the largest) and bad_faces (indices of
the faces that are not valid). A module without OpenCASCADE needs a reader.)";

constexpr const char* kEstimateSolidDoc =
    R"(estimate_solid(vertices, triangles, run=None, format='step', quick=False, **options) -> dict

Estimates the effort of write_solid() with the same options by a trial, which builds and writes the solid,
but makes no file. Returns triangles, faces, megabytes (of a file of this format: 'step' or 'brep'), seconds
(expected duration of write_solid), trial_seconds (the part of seconds that the trial took), tolerance and
deviation (mm), and tried (True). With quick=True there is no trial, and tried is False. This takes
microseconds for each triangle, but faces, megabytes and seconds are then upper bounds, far too large if
surfaces can be recognised. Raises Cancelled, and ExportFailed if write_solid() would refuse the mesh or its
options.)";

}  // namespace swept::python
