// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/assemble.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Message_ProgressScope.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "base/parallel.h"
#include "solid/assemble/pieces.h"
#include "solid/assemble/possible_faces.h"
#include "solid/assemble/solid_of_faces.h"

namespace swept::step {
namespace {

/// The kernel takes about 5 ms for a pair of curved faces whose boxes intersect, some seconds if
/// they are nearly tangent. Of CAD parts along a line, a pulley has 610 such pairs (4 s), a leg of
/// a robot 2,900 (over 2 minutes, and then the faces did not fit together).
constexpr std::size_t kMaxCurvedPairs = 1500;
/// The same, if dividing at known sections has failed: the part has faces that are nearly tangent.
constexpr std::size_t kMaxDifficultPairs = 700;

// The faces of which the envelope may consist: those in use, and those put aside.
class Candidates {
 public:
  Candidates(std::vector<SweptFace> faces, const Sides& sides) {
    std::vector<char> isUsed(faces.size(), 0);
    parallelBlocks(faces.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) isUsed[i] = sides.isOnSurface(faces[i].face);
    });
    for (std::size_t i = 0; i < faces.size(); ++i) (isUsed[i] ? used_ : aside_).push_back(faces[i]);
  }

  /// Takes the faces that were put aside and lie at one of the edges.
  void takeNear(const std::vector<TopoDS_Edge>& edges, TopTools_ListOfShape& to) {
    constexpr double kNear = 1e-3;  // mm
    std::vector<gp_Pnt> points;
    for (const TopoDS_Edge& edge : edges) {
      const BRepAdaptor_Curve curve(edge);
      const double from = curve.FirstParameter(), length = curve.LastParameter() - from;
      for (const double part : {0.05, 0.5, 0.95})
        points.push_back(curve.Value(from + part * length));
    }
    const auto isNear = [&](const SweptFace& candidate) {
      Bnd_Box box;
      BRepBndLib::Add(candidate.face, box);
      box.Enlarge(kNear);
      return std::any_of(points.begin(), points.end(), [&](const gp_Pnt& p) {
        if (box.IsOut(p)) return false;
        const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(p).Shape(),
                                                  candidate.face);
        return distance.IsDone() && distance.Value() < kNear;
      });
    };
    const auto taken = std::stable_partition(aside_.begin(), aside_.end(),
                                             [&](const SweptFace& face) { return !isNear(face); });
    for (auto it = taken; it != aside_.end(); ++it) to.Append(it->face);
    aside_.erase(taken, aside_.end());
  }

  /// Returns the number of pairs of curved faces in use that may intersect.
  std::size_t curvedPairs() const {
    std::vector<const SweptFace*> curved;
    std::vector<Bnd_Box> boxes;
    for (const SweptFace& candidate : used_) {
      if (BRepAdaptor_Surface(candidate.face, Standard_False).GetType() == GeomAbs_Plane) continue;
      curved.push_back(&candidate);
      BRepBndLib::Add(candidate.face, boxes.emplace_back());
    }
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < curved.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool isGroup =
            curved[i]->group != SweptFace::kAlone && curved[i]->group == curved[j]->group;
        pairs += !isGroup && !boxes[i].IsOut(boxes[j]);
      }
    }
    return pairs;
  }

  /// Returns the faces in use, those of one group together.
  TopTools_ListOfShape used() const {
    TopTools_ListOfShape result;
    const BRep_Builder builder;
    std::map<int, TopoDS_Compound> groups;
    for (const SweptFace& candidate : used_) {
      if (candidate.group == SweptFace::kAlone) {
        result.Append(candidate.face);
        continue;
      }
      TopoDS_Compound& group = groups[candidate.group];
      if (group.IsNull()) builder.MakeCompound(group);
      builder.Add(group, candidate.face);
    }
    for (const auto& [pose, group] : groups) result.Append(group);
    return result;
  }

 private:
  std::vector<SweptFace> used_, aside_;
};

// Cuts faces where they intersect. Faces of one argument must not intersect each other. Returns a
// null shape if the kernel fails.
TopoDS_Shape fused(const TopTools_ListOfShape& arguments, const Message_ProgressRange& progress) {
  if (arguments.Size() < 2) return {};
  BOPAlgo_Builder fuser;
  fuser.SetArguments(arguments);
  fuser.SetRunParallel(Standard_True);
  fuser.SetNonDestructive(Standard_True);
  fuser.SetUseOBB(Standard_True);
  fuser.Perform(progress);
  return fuser.HasErrors() ? TopoDS_Shape() : fuser.Shape();
}

PossiblePieces dividedAtSections(const SweptFaces& given, const std::vector<TopoDS_Face>& faces,
                                 double near) {
  try {
    return possiblePieces(divideFaces(faces, *given.sections, near), given.faces);
  } catch (const Standard_Failure&) {
    return {};  // the general fuse may succeed
  }
}

}  // namespace

AssembledSweep assembleSweep(const SweptFaces& faces, const Sides& sides, double volume,
                             double accuracy, const Message_ProgressRange& progress) {
  constexpr int kRounds = 4;
  Message_ProgressScope scope(progress, "", kRounds);
  AssembledSweep failed;
  if (faces.sections) {
    // If ends of sections that belong together are farther apart than expected, the faces do not
    // fit together. Then they are divided again with a larger distance.
    constexpr double kLargerNear = 1e-4;
    std::deque<Pieces> attempts;
    const auto sweepOf = [&](const Pieces& pieces) -> AssembledSweep {
      if (!pieces.openEdges().empty()) return {};
      return {solidOf(pieces.chosen(), volume, accuracy), pieces.areCertain(), pieces.filled(),
              pieces.certain()};
    };
    std::vector<TopoDS_Face> kernelFaces;
    for (const SweptFace& face : faces.faces) kernelFaces.push_back(face.face);
    std::set<double> distances;
    for (const double near : {faces.near, kLargerNear, kMaxNear})
      distances.insert(joiningDistance(kernelFaces, near));
    for (const double near : distances) {
      if (scope.UserBreak()) return {};
      const PossiblePieces divided = dividedAtSections(faces, kernelFaces, near);
      if (divided.shape.IsNull()) continue;
      const AssembledSweep sweep =
          sweepOf(attempts.emplace_back(divided.shape, sides, divided.unlikely));
      if (!sweep.shape.IsNull()) return sweep;
    }
    const auto hasFewerOpenEdges = [](const Pieces& a, const Pieces& b) {
      return a.openEdges().size() < b.openEdges().size();
    };
    for (Pieces& pieces : attempts) {
      if (pieces.openEdges().empty()) continue;  // filling would change nothing
      pieces.fillGrooves();
      const AssembledSweep sweep = sweepOf(pieces);
      if (!sweep.shape.IsNull()) return sweep;
    }
    const auto best = std::min_element(attempts.begin(), attempts.end(), hasFewerOpenEdges);
    if (best != attempts.end()) failed.parts = best->certain();
  }
  if (!faces.canFuse) return failed;
  Candidates candidates(faces.faces, sides);
  if (candidates.curvedPairs() > (faces.sections ? kMaxDifficultPairs : kMaxCurvedPairs))
    return failed;
  TopTools_ListOfShape arguments = candidates.used();
  std::size_t before = 0;  // open edges of the previous round
  for (int round = 0; round < kRounds; ++round) {
    const TopoDS_Shape cut = fused(arguments, scope.Next());
    if (cut.IsNull() || scope.UserBreak()) return failed;
    const Pieces pieces(cut, sides);
    if (failed.parts.empty()) failed.parts = pieces.certain();
    const std::vector<TopoDS_Edge> open = pieces.openEdges();
    for (const bool cells : {true, false}) {
      if (!cells && !open.empty()) continue;
      const TopoDS_Shape solid =
          solidOf(cells ? pieces.aroundCells() : pieces.chosen(), volume, accuracy);
      if (!solid.IsNull()) return {solid, false, 0, pieces.certain()};
    }
    if (open.empty() || open.size() == before) return failed;
    before = open.size();
    arguments = pieces.looseNear(open);
    candidates.takeNear(open, arguments);
  }
  return failed;
}

}  // namespace swept::step
