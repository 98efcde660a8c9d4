// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/swept_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <Message_ProgressScope.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <memory>
#include <optional>

#include "motion/pivot.h"
#include "motion/step_path.h"
#include "solid/assemble/cut_body.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/mesh_sections.h"
#include "solid/assemble/possible_faces.h"
#include "solid/assemble/solid_of_faces.h"
#include "solid/assemble/straight_sections.h"
#include "solid/assemble/turning_faces.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Number of faces of the body times number of moves. With more, the kernel would take minutes.
constexpr std::size_t kMaxFaces = 2000;
/// The same if the body moves and turns at the same time, for up to ten steps and for more. The
/// time grows with the number of faces and with the square of the number of steps: the foot of a
/// robot, 237 faces along two steps, takes 75 CPU seconds, a pulley of 76 faces 45 along two steps
/// and 100 along four. A starter motor of 27 faces along eleven steps takes 80, and has
/// 911 faces in 12 MB; with surfaces recognised in the mesh, it has 1,123 in 1 MB, after 3.
constexpr std::size_t kFewSteps = 10, kMaxTurningFaces = 500, kMaxFacesOfManySteps = 250;
/// Shorter moves (mm) and smaller turns (rad) are no motion.
constexpr double kNoMove = 1e-9, kNoTurn = 1e-10;

// One motion step: a straight move, or a turn about a fixed axis.
struct Move {
  gp_Vec shift;  // if angle is 0
  gp_Ax1 axis;
  double angle = 0;

  bool isRest() const { return angle == 0 && shift.Magnitude() <= kNoMove; }
  gp_Vec velocityAt(const gp_Pnt& p) const {
    return angle == 0 ? shift
                      : gp_Vec(axis.Direction()).Crossed(gp_Vec(axis.Location(), p)) * angle;
  }
  // Returns whether the edge slides along itself.
  bool slides(const TopoDS_Edge& edge) const {
    const BRepAdaptor_Curve curve(edge);
    constexpr int kSteps = 8;
    for (int i = 0; i <= kSteps; ++i) {
      gp_Pnt p;
      gp_Vec along;
      curve.D1(
          curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / kSteps, p,
          along);
      const gp_Vec v = velocityAt(p);
      if (along.Crossed(v).Magnitude() > 1e-7 * along.Magnitude() * v.Magnitude()) return false;
    }
    return true;
  }
};

std::optional<Move> moveOf(const Pose& from, const Pose& to, Interpolation interpolation) {
  const StepPath path(from, to, interpolation);
  Move move;
  if (path.angle() <= kNoTurn) {
    move.shift = vecOf(to.translation - from.translation);
    return move;
  }
  if (std::abs(path.isScrew() ? path.pitch() : path.drift()) > kNoMove) return std::nullopt;
  const Vector3d point = path.isScrew() ? path.axisPoint() : from.translation;
  move.axis = gp_Ax1(pointOf(point), gp_Dir(vecOf(path.axis())));
  move.angle = path.angle();
  return move;
}

// What the faces and edges of a shape sweep, with shared edges.
class Sweeper {
 public:
  Sweeper(const TopoDS_Shape& shape, const Move& move) {
    if (move.angle == 0) {
      prism_ = std::make_unique<BRepPrimAPI_MakePrism>(shape, move.shift);
    } else {
      turn_ = std::make_unique<BRepPrimAPI_MakeRevol>(shape, move.axis, move.angle);
    }
  }
  TopoDS_Face atEnd(const TopoDS_Shape& face) {
    const TopoDS_Shape moved = prism_ ? prism_->LastShape(face) : turn_->LastShape(face);
    return TopoDS::Face(moved.Oriented(face.Orientation()));
  }
  const TopTools_ListOfShape& sweptBy(const TopoDS_Shape& edge) {
    return prism_ ? prism_->Generated(edge) : turn_->Generated(edge);
  }

 private:
  std::unique_ptr<BRepPrimAPI_MakePrism> prism_;
  std::unique_ptr<BRepPrimAPI_MakeRevol> turn_;
};

// The parts of the body that sweep faces in one step. Indices of faces are those in SweptFaces.
struct SweepingParts {
  std::vector<CapFace> caps;
  std::vector<int> atStart, atEnd;  // faces of the caps
  std::vector<TopoDS_Edge> edges, sweeping;
  std::vector<int> swept;  // faces of the sweeping edges
};

// Appends the faces of one step. The body is at the pose at which the step starts.
bool appendStep(const TopoDS_Shape& body, const Move& move, int pose, bool isFirst,
                std::vector<SweptFace>& to, SweepingParts& sources,
                const Message_ProgressRange& progress) {
  const auto next = [&] { return static_cast<int>(to.size()); };
  const Velocity velocity = [&](const gp_Pnt& p) { return move.velocityAt(p); };
  const TopoDS_Compound parts = cutAtContact(body, velocity, progress);
  if (parts.IsNull()) return false;
  Sweeper sweeper(parts, move);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(parts, TopAbs_FACE, faces);
  std::vector<int> sides(faces.Extent() + 1);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face& face = TopoDS::Face(faces(i));
    sides[i] = sideOf(face, velocity);
    const CapFace cap{face, isFirst && sides[i] <= 0, sides[i] >= 0};
    sources.caps.push_back(cap);
    sources.atStart.push_back(next());
    if (cap.atStart) to.push_back({face, pose});
    sources.atEnd.push_back(next());
    if (cap.atEnd) to.push_back({sweeper.atEnd(face), pose + 1});
  }
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(parts, TopAbs_EDGE, TopAbs_FACE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    sources.edges.push_back(edge);
    if (move.slides(edge)) continue;
    bool isOutward = false, isInward = false;
    for (const TopoDS_Shape& face : edges(i)) {
      const int side = sides[faces.FindIndex(face)];
      isOutward |= side >= 0;
      isInward |= side <= 0;
    }
    if (!isOutward || !isInward) continue;
    sources.sweeping.push_back(edge);
    sources.swept.push_back(next());
    for (const TopoDS_Shape& swept : sweeper.sweptBy(edge)) {
      for (TopExp_Explorer it(swept, TopAbs_FACE); it.More(); it.Next())
        to.push_back({TopoDS::Face(it.Current()), SweptFace::kAlone});
    }
  }
  return true;
}

std::vector<SweptSection> sectionsOf(const SweepingParts& sources, const Move& move,
                                     const Sides& sides) {
  std::vector<SweptSection> sections;
  for (const StraightSection& found :
       straightSections(sources.caps, sources.sweeping, sources.edges, move.shift, sides)) {
    const int other = found.cap < 0 ? sources.swept[found.other]
                      : found.atEnd ? sources.atEnd[found.cap]
                                    : sources.atStart[found.cap];
    sections.push_back({found.edge, {sources.swept[found.sweeping], other}});
  }
  return sections;
}

// Solids of an assembly may have faces at one place. The sections are not meant for these.
bool isOneSolid(const TopoDS_Shape& shape) { return countOf(shape, TopAbs_SOLID) <= 1; }

// Returns nothing if a step is of another kind.
std::optional<std::vector<Move>> movesOf(const Trajectory& trajectory) {
  if (trajectory.interpolation == Interpolation::None || trajectory.poses.size() < 2)
    return std::nullopt;
  const Trajectory carried = carriedByPivot(trajectory, pivotOf(trajectory));
  std::vector<Move> moves;
  for (std::size_t k = 0; k + 1 < carried.poses.size(); ++k) {
    const auto move = moveOf(carried.poses[k], carried.poses[k + 1], carried.interpolation);
    if (!move) return std::nullopt;
    moves.push_back(*move);
  }
  return moves;
}

std::size_t faceCount(const TopoDS_Shape& shape) { return countOf(shape, TopAbs_FACE); }

// Returns the trajectory without steps in which the body is at rest.
Trajectory withoutRests(Trajectory trajectory) {
  std::vector<Pose> moving;
  for (const Pose& pose : trajectory.poses) {
    if (!moving.empty()) {
      const auto move = moveOf(moving.back(), pose, trajectory.interpolation);
      if (move && move->isRest()) continue;
    }
    moving.push_back(pose);
  }
  trajectory.poses = std::move(moving);
  return trajectory;
}

// Returns whether turningFaces() can make the faces.
bool canTurn(const BodyShape& body, const Trajectory& trajectory) {
  if (trajectory.interpolation == Interpolation::None || trajectory.poses.size() < 2) return false;
  const std::size_t steps = trajectory.poses.size() - 1;
  const std::size_t most = steps <= kFewSteps ? kMaxTurningFaces : kMaxFacesOfManySteps;
  return faceCount(body.shape) * steps <= most && isOneSolid(body.shape);
}

SweptFaces facesOfTurns(const BodyShape& body, const Trajectory& trajectory, const Sides& sides,
                        const Message_ProgressRange& progress) {
  constexpr double kExact = 2e-6;  // mm; neither the faces nor their sections are less exact
  const Vector3d pivot = pivotOf(trajectory);
  gp_Trsf toPivot;
  toPivot.SetTranslation(vecOf(-pivot));
  const TopoDS_Shape seen = BRepBuilderAPI_Transform(body.shape, toPivot, Standard_True).Shape();
  auto made = turningFaces(seen, withoutRests(carriedByPivot(trajectory, pivot)));
  if (!made) return {};
  dropImpossible(*made);
  SweptFaces result;
  result.faces = made->faces;
  result.sections =
      meshSections(made->faces, made->dividers, made->folds, made->crossings, sides, progress);
  result.near = kExact;
  result.canFuse = false;
  return result;
}

}  // namespace

bool canSweepFaces(const BodyShape& body, const Trajectory& trajectory) {
  if (!movesOf(trajectory)) return canTurn(body, trajectory);
  return faceCount(body.shape) * (trajectory.poses.size() - 1) <= kMaxFaces;
}

SweptFaces sweptFaces(const BodyShape& body, const Trajectory& trajectory, const Sides& sides,
                      const Message_ProgressRange& progress) {
  const auto simple = movesOf(trajectory);
  if (!simple) return facesOfTurns(body, trajectory, sides, progress);
  const std::vector<Move>& moves = *simple;
  const auto isMoving = [](const Move& move) { return !move.isRest(); };
  const bool isSingle = std::count_if(moves.begin(), moves.end(), isMoving) == 1;
  SweptFaces faces;
  Message_ProgressScope scope(progress, "", static_cast<double>(moves.size()));
  bool isFirst = true;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const Message_ProgressRange range = scope.Next();
    if (moves[k].isRest()) continue;
    const TopoDS_Shape posed =
        BRepBuilderAPI_Transform(body.shape, transformOf(trajectory.poses[k]), Standard_True)
            .Shape();
    SweepingParts sources;
    if (!appendStep(posed, moves[k], static_cast<int>(k), isFirst, faces.faces, sources, range))
      return {};
    if (isSingle && moves[k].angle == 0 && isOneSolid(body.shape)) {
      try {
        faces.sections = sectionsOf(sources, moves[k], sides);
      } catch (const Standard_Failure&) {
        // The kernel's general fuse may find the sections.
      }
    }
    isFirst = false;
  }
  return faces;
}

}  // namespace swept::step
