// Plain values that all parts of the project share: status, mesh, pose, trajectory, options.
// Units: mm, s and rad, unless a name says otherwise.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace swept {

/// How a run ended. Every run ends with exactly one of these (docs/pipeline.md, "The promise").
enum class Status {
  Ok,
  InvalidInput,
  ResourceLimit,
  OutOfMemory,
  Cancelled,
  DeviceUnavailable,
  DeviceLost,
  ExportFailed,
  InternalError,
};

/// Returns the name of a status as reports show it, for example "InvalidInput".
const char* statusName(Status status);

/// Thrown by stages, and caught only where a call of the library ends, in Python and in the
/// programs. `code` is for programs ("NonFiniteVertex"). what() is for people: what is wrong,
/// where, by how much, and what to do.
class Error : public std::runtime_error {
 public:
  Error(Status status, std::string code, const std::string& message)
      : std::runtime_error(message), status_(status), code_(std::move(code)) {}
  Status status() const { return status_; }
  const std::string& code() const { return code_; }

 private:
  Status status_;
  std::string code_;
};

/// Indexed triangles, counter-clockwise seen from outside. Vertices in mm.
struct TriMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::int32_t, 3>> triangles;
  /// Only for bodies: for each triangle, the index (from 0) of the face to which it belongs. Empty:
  /// not known. Used only if Options::sources is set.
  std::vector<std::int32_t> faceOf{};
};

/// One rigid placement of the moving body: x_world = rotation * x + translation.
struct Pose {
  double timeSeconds = 0;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// Motion of the body between two poses. None: no motion; the result is the union of the body at
/// all poses. Linear: the pivot moves in a straight line, and the rotation is interpolated by
/// slerp. Screw: one screw motion.
enum class Interpolation { None, Linear, Screw };

struct Trajectory {
  std::vector<Pose> poses;
  Interpolation interpolation = Interpolation::Linear;
  /// mm, in coordinates of the body: the point that moves in a straight line between two poses
  /// (Linear).
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
};

/// How crossings in a cell are joined to components of the surface (docs/contouring.md).
enum class ComponentMethod { DualContouring, DualMarchingCubes, Equivalence, Greedy, Consistent };

enum class Backend { Auto, Cpu, Gpu };

/// The chord tolerance as a fraction of the cell, and the weld tolerance as a fraction of the
/// diagonal of the body's bounding box, where the options give none.
constexpr double kChordFraction = 0.02, kWeldFraction = 1e-6;

/// Settings of one run.
struct Options {
  int resolution = 128;  ///< cells along the longest side of the sweep; used if cellSize is not set
  std::optional<double> cellSize;  ///< mm, above 0; not set: derived from `resolution`
  ComponentMethod components = ComponentMethod::Consistent;
  Backend backend = Backend::Auto;
  bool keepCavities = false;  ///< keep enclosed cavities as inner shells
  bool cull = true;  ///< leave out faces and side patches that provably lie inside the swept volume
  double tolerance = 0;       ///< mm, largest deviation by simplification; 0: no simplification
  double offset = 0;          ///< mm, distance by which the envelope is grown
  bool conservative = false;  ///< the envelope provably contains the swept volume
  /// mm; skip poses while no point of the body moves farther than this; 0: use all poses.
  double positionFilter = 0;
  /// mm: how far the true path of a point may deviate from its chord; above 0 up to the size of a
  /// cell. Not set: kChordFraction of a cell.
  std::optional<double> chordTolerance;
  /// mm: vertices on open edges that are closer than this are joined; 0 up to a hundredth of the
  /// diagonal of the body's bounding box. Not set: kWeldFraction of this diagonal.
  std::optional<double> weldTolerance;
  /// Record what made each triangle (sources.h). Not allowed with an offset or with `conservative`.
  bool sources = false;
};

/// Names used on the command line, in Python and in FreeCAD properties. The parse functions throw
/// Error(InvalidInput, "BadOption") with the allowed names.
const char* interpolationName(Interpolation value);
const char* componentMethodName(ComponentMethod value);
const char* backendName(Backend value);
Interpolation parseInterpolation(const std::string& text);  // none | linear | screw
ComponentMethod parseComponentMethod(
    const std::string& text);                   // dc | dmc | equivalence | greedy | consistent
Backend parseBackend(const std::string& text);  // auto | cpu | gpu
/// Returns the millimetres per unit for "mm", "cm", "m" or "in".
double parseLengthUnit(const std::string& text);

}  // namespace swept
