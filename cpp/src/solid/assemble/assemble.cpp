// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/assemble.h"

#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_MakerVolume.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message_ProgressScope.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "solid/assemble/face_samples.h"
#include "solid/assemble/shape_triangles.h"
#include "solid/assemble/swept_faces.h"
#include "solid/assemble/swept_interior.h"

namespace swept::step {
namespace {

/// Fractions of the size of the body: how far its triangles may lie from its faces, and how far
/// sample points lie from the face that they judge.
constexpr double kDeflection = 1.0 / 80000, kSampleDistance = 1.0 / 30000;
constexpr double kAngle = 0.1;  // rad, between adjacent triangles of the body
/// The kernel takes about 5 ms for a pair of curved faces whose boxes intersect, some seconds if
/// they are nearly tangent. Of CAD parts along a line, a pulley has 610 such pairs (4 s), a leg of
/// a robot 2,900 (over 2 minutes, and then the faces did not fit together).
constexpr std::size_t kMaxCurvedPairs = 1500;

double sizeOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

// Where samples of a piece see the swept volume: behind the piece only, before it only (on the side
// of the normal), on both sides, or on none.
struct Votes {
  int behind = 0, before = 0, both = 0, none = 0;
  int count() const { return behind + before + both + none; }
};

// Judges on which side of a face the swept volume is.
class Sides {
 public:
  Sides(const TopoDS_Shape& body, const Trajectory& trajectory)
      : size_(sizeOf(body)),
        interior_(
            trianglesOf(BRepBuilderAPI_Copy(body, Standard_False), kDeflection * size_, kAngle),
            trajectory, kDeflection * size_) {}

  double distance() const { return kSampleDistance * size_; }

  void vote(const FaceSample& sample, Votes& votes) const {
    const gp_Vec off = gp_Vec(sample.normal) * distance();
    const bool before = contains(sample.point.Translated(off));
    const bool behind = contains(sample.point.Translated(-off));
    ++(before ? (behind ? votes.both : votes.before) : (behind ? votes.behind : votes.none));
  }

  /// Returns whether a sample of the face lies on the surface of the swept volume.
  bool isOnSurface(const TopoDS_Face& face) const {
    constexpr int kSamples = 200;
    const std::vector<FaceSample> samples = samplesOf(face, kSamples);
    return std::any_of(samples.begin(), samples.end(), [&](const FaceSample& sample) {
      Votes votes;
      vote(sample, votes);
      return votes.behind + votes.before > 0;
    });
  }

 private:
  bool contains(const gp_Pnt& p) const { return interior_.contains({p.X(), p.Y(), p.Z()}); }
  double size_;
  SweptInterior interior_;
};

// The pieces into which all faces cut each other.
class Pieces {
 public:
  Pieces(const TopoDS_Shape& fused, const Sides& sides) : fused_(fused), sides_(sides) {
    TopExp::MapShapes(fused, TopAbs_FACE, faces_);
    TopExp::MapShapesAndAncestors(fused, TopAbs_EDGE, TopAbs_FACE, edges_);
    votes_.resize(faces_.Extent() + 1);
    parallelBlocks(faces_.Extent(), 1, [&](std::size_t begin, std::size_t end) {
      constexpr int kSamples = 9;
      for (std::size_t f = begin + 1; f <= end; ++f) {
        for (const FaceSample& sample : samplesOf(face(static_cast<int>(f)), kSamples))
          sides_.vote(sample, votes_[f]);
      }
    });
    choose();
  }

  /// Returns the faces that bound the swept volume, their normals away from it: those of the cells
  /// that the pieces enclose and that lie inside. Empty if the pieces enclose nothing.
  std::vector<TopoDS_Face> aroundCells() const {
    BOPAlgo_MakerVolume maker;
    TopTools_ListOfShape arguments;
    arguments.Append(fused_);
    maker.SetArguments(arguments);
    maker.SetIntersect(Standard_False);
    maker.SetAvoidInternalShapes(Standard_True);
    maker.SetRunParallel(Standard_True);
    maker.Perform();
    if (maker.HasErrors()) return {};
    std::vector<std::vector<TopoDS_Shape>> uses(faces_.Extent() + 1);
    for (TopExp_Explorer cell(maker.Shape(), TopAbs_SOLID); cell.More(); cell.Next()) {
      if (!isInside(cell.Current())) continue;
      for (TopExp_Explorer it(cell.Current(), TopAbs_FACE); it.More(); it.Next())
        uses[faces_.FindIndex(it.Current())].push_back(it.Current());
    }
    std::vector<TopoDS_Face> result;
    for (const auto& use : uses) {
      if (use.size() == 1) result.push_back(TopoDS::Face(use.front()));
    }
    return result;
  }

  /// Returns the pieces that most samples see on the surface of the swept volume, with their
  /// normals away from it.
  std::vector<TopoDS_Face> chosen() const {
    std::vector<TopoDS_Face> result;
    for (int f = 1; f <= faces_.Extent(); ++f) {
      if (!chosen_[f]) continue;
      const bool isTurned = votes_[f].before > votes_[f].behind;
      result.push_back(TopoDS::Face(isTurned ? faces_(f).Reversed() : faces_(f)));
    }
    return result;
  }

  /// Returns the pieces, those at the edges one by one, the others together.
  TopTools_ListOfShape looseNear(const std::vector<TopoDS_Edge>& edges) const {
    TopTools_MapOfShape loose;
    for (const TopoDS_Edge& edge : edges) {
      for (const TopoDS_Shape& piece : edges_.FindFromKey(edge)) loose.Add(piece);
    }
    const BRep_Builder builder;
    TopoDS_Compound others;
    builder.MakeCompound(others);
    TopTools_ListOfShape result;
    for (int f = 1; f <= faces_.Extent(); ++f) {
      if (loose.Contains(faces_(f))) {
        result.Append(faces_(f));
      } else {
        builder.Add(others, faces_(f));
      }
    }
    result.Append(others);
    return result;
  }

  /// Returns the edges of chosen pieces that do not have two of them.
  std::vector<TopoDS_Edge> openEdges() const {
    std::vector<TopoDS_Edge> open;
    for (int e = 1; e <= edges_.Extent(); ++e) {
      if (uses(e) % 2 == 1) open.push_back(TopoDS::Edge(edges_.FindKey(e)));
    }
    return open;
  }

 private:
  TopoDS_Face face(int f) const { return TopoDS::Face(faces_(f)); }

  bool isInside(const TopoDS_Shape& cell) const {
    int inside = 0, count = 0;
    for (TopExp_Explorer it(cell, TopAbs_FACE); it.More(); it.Next()) {
      const int f = faces_.FindIndex(it.Current());
      const Votes& votes = votes_[f];
      const bool isBehind = it.Current().Orientation() == faces_(f).Orientation();
      inside += votes.both + (isBehind ? votes.behind : votes.before);
      count += votes.count();
    }
    return 2 * inside > count;
  }

  // Returns how often chosen pieces use the edge. `flipped`: a piece whose choice is inverted.
  int uses(int e, int flipped = 0) const {
    const TopoDS_Edge& edge = TopoDS::Edge(edges_.FindKey(e));
    if (BRep_Tool::Degenerated(edge)) return 0;
    int count = 0;
    TopTools_MapOfShape seen;
    for (const TopoDS_Shape& owner : edges_(e)) {
      const int f = faces_.FindIndex(owner);
      const bool isChosen = (chosen_[f] != 0) != (f == flipped);
      if (seen.Add(owner) && isChosen) count += BRep_Tool::IsClosed(edge, face(f)) ? 2 : 1;
    }
    return count;
  }

  int openEdgesOf(int f, bool isFlipped) const {
    int count = 0;
    for (TopExp_Explorer it(faces_(f), TopAbs_EDGE); it.More(); it.Next())
      count += uses(edges_.FindIndex(it.Current()), isFlipped ? f : 0) % 2;
    return count;
  }

  // Chooses pieces by their votes. The samples cannot judge pieces that are narrower than their
  // distance. So choices are inverted where this leaves fewer open edges.
  void choose() {
    constexpr int kMaxChanges = 200;
    chosen_.assign(faces_.Extent() + 1, 0);
    for (int f = 1; f <= faces_.Extent(); ++f) {
      const Votes& votes = votes_[f];
      chosen_[f] = std::max(votes.behind, votes.before) > votes.both + votes.none;
    }
    for (int changes = 0, before = -1; changes != before && changes < kMaxChanges;) {
      before = changes;
      for (int f = 1; f <= faces_.Extent(); ++f) {
        const int open = openEdgesOf(f, false);
        if (open == 0) continue;
        const int left = openEdgesOf(f, true);
        if (left >= open || (left > 0 && !isDoubtful(f))) continue;
        chosen_[f] = !chosen_[f];
        ++changes;
      }
    }
  }

  bool isDoubtful(int f) const {
    constexpr double kNarrow = 30;  // times the distance of the samples
    const Votes& votes = votes_[f];
    const int most = std::max({votes.behind, votes.before, votes.both + votes.none});
    if (most < votes.count() || votes.count() < 3) return true;
    GProp_GProps area;
    BRepGProp::SurfaceProperties(faces_(f), area);
    return std::sqrt(std::abs(area.Mass())) < kNarrow * sides_.distance();
  }

  const TopoDS_Shape fused_;
  const Sides& sides_;
  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedDataMapOfShapeListOfShape edges_;
  std::vector<Votes> votes_;  // by piece, from 1
  std::vector<char> chosen_;
};

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

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

// Makes one solid for each outer shell. Cavities are shells with a negative volume.
TopoDS_Shape solidsOf(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Face& face : faces) builder.Add(all, face);
  TopTools_ListOfShape blocks;
  BOPTools_AlgoTools::MakeConnexityBlocks(all, TopAbs_EDGE, TopAbs_FACE, blocks);
  std::vector<TopoDS_Solid> solids;
  std::vector<TopoDS_Shell> cavities;
  for (const TopoDS_Shape& block : blocks) {
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (TopExp_Explorer face(block, TopAbs_FACE); face.More(); face.Next())
      builder.Add(shell, face.Current());
    shell.Closed(Standard_True);
    if (volumeOf(shell) < 0) {
      cavities.push_back(shell);
      continue;
    }
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    solids.push_back(solid);
  }
  if (solids.empty() || (!cavities.empty() && solids.size() > 1)) return {};
  for (const TopoDS_Shell& cavity : cavities) builder.Add(solids.front(), cavity);
  if (solids.size() == 1) return solids.front();
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for (const TopoDS_Solid& solid : solids) builder.Add(result, solid);
  return result;
}

// Joins adjacent pieces of one surface. Returns a null shape if the solid cannot be made valid.
TopoDS_Shape unified(const TopoDS_Shape& solids) {
  ShapeUpgrade_UnifySameDomain joiner(solids, Standard_True, Standard_True, Standard_False);
  joiner.Build();
  for (const TopoDS_Shape& shape : {joiner.Shape(), solids}) {
    if (BRepCheck_Analyzer(shape).IsValid()) return shape;
    ShapeFix_Shape mender(shape);
    mender.Perform();
    if (BRepCheck_Analyzer(mender.Shape()).IsValid()) return mender.Shape();
  }
  return {};
}

}  // namespace

TopoDS_Shape assembleSweep(const BodyShape& body, const Trajectory& trajectory, double volume,
                           double accuracy, const Message_ProgressRange& progress) {
  constexpr int kRounds = 4;
  Message_ProgressScope scope(progress, "", kRounds + 1);
  const std::vector<SweptFace> faces = sweptFaces(body, trajectory, scope.Next());
  if (faces.empty() || scope.UserBreak()) return {};
  const Sides sides(body.shape, trajectory);
  Candidates candidates(faces, sides);
  if (candidates.curvedPairs() > kMaxCurvedPairs) return {};
  TopTools_ListOfShape arguments = candidates.used();
  std::size_t before = 0;  // open edges of the previous round
  for (int round = 0; round < kRounds; ++round) {
    const TopoDS_Shape cut = fused(arguments, scope.Next());
    if (cut.IsNull() || scope.UserBreak()) return {};
    const Pieces pieces(cut, sides);
    const std::vector<TopoDS_Edge> open = pieces.openEdges();
    for (const bool cells : {true, false}) {
      if (!cells && !open.empty()) continue;
      const TopoDS_Shape solids = solidsOf(cells ? pieces.aroundCells() : pieces.chosen());
      if (solids.IsNull() || std::abs(volumeOf(solids) - volume) > accuracy) continue;
      const TopoDS_Shape joined = unified(solids);
      if (!joined.IsNull()) return joined;
    }
    if (open.empty() || open.size() == before) return {};
    before = open.size();
    arguments = pieces.looseNear(open);
    candidates.takeNear(open, arguments);
  }
  return {};
}

}  // namespace swept::step
