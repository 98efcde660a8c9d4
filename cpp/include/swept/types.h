// Plain values shared by every part of the project: status, mesh, pose, trajectory, options.
// Units: mm, s, rad unless a name says otherwise.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace swept {

/// How a run ended. Every run ends in exactly one of these (docs/pipeline.md, "The promise").
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

/// Name of a status as it stands in reports, e.g. "InvalidInput".
const char* statusName(Status status);

/// Thrown by stages; caught at the boundaries only (pipeline/compute.cpp, step/, python/, tools/).
/// `code` is the machine-readable finding ("NonFiniteVertex"), what() says what, where, how much,
/// and what to do.
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

/// Indexed triangles; counter-clockwise seen from outside. Vertices in mm.
struct TriMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::int32_t, 3>> triangles;
  /// Of a body: per triangle the number (0 or more) of the face that it is a piece of. Empty: not
  /// known. Read where Options::sources asks for it.
  std::vector<std::int32_t> faceOf{};
};

/// One rigid placement of the moving body: x_world = rotation * x + translation.
struct Pose {
  double timeSeconds = 0;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// What the body does between two poses. None: nothing, the poses are a union of posed copies.
/// Linear: straight line of the pivot + rotation slerp. Screw: constant screw motion.
enum class Interpolation { None, Linear, Screw };

struct Trajectory {
  std::vector<Pose> poses;
  Interpolation interpolation = Interpolation::Linear;
  /// mm, in the body's coordinates: the point that moves straight between two poses (Linear).
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
};

/// How crossings of a cell are joined to surface components (docs/contouring.md).
enum class ComponentMethod { DualContouring, DualMarchingCubes, Equivalence, Greedy, Consistent };

enum class Backend { Auto, Cpu, Gpu };

/// Settings of one run. Zero means "not given" where a comment says so.
struct Options {
  int resolution = 128;  ///< cells along the longest side of the sweep; used if cellSize == 0
  double cellSize = 0;   ///< mm; 0: from resolution
  ComponentMethod components = ComponentMethod::Consistent;
  Backend backend = Backend::Auto;
  bool keepCavities = false;  ///< keep sealed-off hollow spaces as inner shells
  bool cull = true;           ///< drop faces and patches that are provably enclosed
  double tolerance = 0;       ///< mm, simplification: largest deviation allowed; 0: off
  double offset = 0;          ///< mm, safety distance by which the envelope is grown
  bool conservative = false;  ///< envelope provably contains the swept volume
  double positionFilter = 0;  ///< mm; drop poses while the body stays within this; 0: off
  double chordTolerance =
      0.02;                     ///< of a cell: how far a point may leave the refined motion's chord
  double weldTolerance = 1e-6;  ///< of the body's box diagonal
  /// Tell of each triangle what made it (sources.h); neither with an offset nor conservative.
  bool sources = false;
};

/// Names as used on the command line, in Python and in FreeCAD properties; parse throws
/// Error(InvalidInput, "BadOption") listing the allowed names.
const char* interpolationName(Interpolation value);
const char* componentMethodName(ComponentMethod value);
const char* backendName(Backend value);
Interpolation parseInterpolation(const std::string& text);  // none | linear | screw
ComponentMethod parseComponentMethod(
    const std::string& text);                   // dc | dmc | equivalence | greedy | consistent
Backend parseBackend(const std::string& text);  // auto | cpu | gpu
/// Millimetres per unit for "mm", "cm", "m", "in".
double parseLengthUnit(const std::string& text);

}  // namespace swept
