// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fine_triangles.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "geometry/cut_triangle.h"
#include "geometry/half_edges.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/shape_triangles.h"
#include "solid/assemble/solid_of_faces.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Fractions of the size of the body: how far the kernel's triangles may lie from the body, how far
/// the final ones at most, and below which distance nothing is gained.
constexpr double kStart = 1.0 / 2000, kLeast = 1.0 / 80000, kHighest = 1e-7;
constexpr double kAngle = 0.1;  // rad, between the kernel's triangles
/// 500,000 triangles took 40 MB more than 27,000.
constexpr std::size_t kMaxTriangles = 1200000;

// The triangles of one face.
class FaceTriangles {
 public:
  explicit FaceTriangles(const FaceWithTriangles& meshed)
      : surface_(meshed.face, Standard_False),
        isReversed_(meshed.face.Orientation() == TopAbs_REVERSED),
        number_(meshed.number) {
    const TopoDS_Face& face = meshed.face;
    TopLoc_Location location;
    const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
    if (part.IsNull() || !part->HasUVNodes()) return;
    for (int i = 1; i <= part->NbNodes(); ++i)
      nodes_.push_back(
          {vectorOf(part->Node(i).Transformed(location.Transformation()).XYZ()), part->UVNode(i)});
    for (int i = 1; i <= part->NbTriangles(); ++i) {
      Triangle& t = triangles_.emplace_back();
      part->Triangle(i).Get(t[0], t[1], t[2]);
      for (std::int32_t& v : t) --v;
    }
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
      addBorder(TopoDS::Edge(it.Current()), face, part, location);
  }

  std::size_t count() const { return triangles_.size(); }

  /// Halves sides until they are at most `off` away from the face. Stops with a part of the work
  /// if there would be more than `max` triangles.
  void refine(double off, std::size_t max) {
    // Cutting a triangle with three corners on a line may never end, as sides across it are long.
    constexpr int kMaxRounds = 30;
    std::vector<Triangle> fine, rest = std::move(triangles_);
    for (int round = 0; round < kMaxRounds && !rest.empty() && fine.size() + rest.size() <= max;
         ++round) {
      std::unordered_map<std::uint64_t, std::int32_t> middles;
      middles.reserve(2 * rest.size());
      const auto middleOf = [&](std::int32_t a, std::int32_t b) {
        const auto [at, isNew] = middles.try_emplace(edgeKey(a, b), kNotCut);
        const Side side = std::minmax(a, b);
        if (isNew && isOff(side, off)) at->second = halved(side);
        return at->second;
      };
      std::vector<Triangle> next;
      for (const Triangle& t : rest) {
        const Triangle middle{middleOf(t[0], t[1]), middleOf(t[1], t[2]), middleOf(t[2], t[0])};
        const bool isFine = middle == Triangle{kNotCut, kNotCut, kNotCut};
        cutTriangle(
            t, middle,
            [&](std::int32_t a, std::int32_t b) {
              return (nodes_[a].at - nodes_[b].at).squaredNorm();
            },
            [&](std::int32_t a, std::int32_t b, std::int32_t c) {
              (isFine ? fine : next).push_back({a, b, c});
            });
      }
      rest = std::move(next);
    }
    fine.insert(fine.end(), rest.begin(), rest.end());
    triangles_ = std::move(fine);
  }

  void appendTo(TriMesh& mesh) const {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Node& node : nodes_) mesh.vertices.push_back(node.at);
    for (const Triangle& t : triangles_)
      mesh.triangles.push_back(
          {first + t[0], first + t[isReversed_ ? 2 : 1], first + t[isReversed_ ? 1 : 2]});
    mesh.faceOf.resize(mesh.triangles.size(), number_);
  }

 private:
  struct Node {
    Vector3d at;
    gp_Pnt2d on;
  };
  using Triangle = std::array<std::int32_t, 3>;
  using Side = std::pair<std::int32_t, std::int32_t>;  // sorted
  struct BorderEdge {
    BRepAdaptor_Curve curve;
    Handle(Geom2d_Curve) on;
  };
  struct BorderSide {
    int edge;
    double from, to;  // parameters of its nodes, in the order of Side
  };

  void addBorder(const TopoDS_Edge& edge, const TopoDS_Face& face,
                 const Handle(Poly_Triangulation) & part, const TopLoc_Location& location) {
    const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(edge, part, location);
    if (BRep_Tool::Degenerated(edge) || polygon.IsNull() || !polygon->HasParameters()) return;
    edges_.push_back({BRepAdaptor_Curve(edge), curveOn(face, edge, *polygon, *part)});
    for (int i = 1; i < polygon->NbNodes(); ++i)
      addBorderSide(
          polygon->Node(i) - 1, polygon->Node(i + 1) - 1,
          {static_cast<int>(edges_.size()) - 1, polygon->Parameter(i), polygon->Parameter(i + 1)});
  }

  // Returns the curve of an edge on which the nodes lie. At a seam there are two.
  static Handle(Geom2d_Curve)
      curveOn(const TopoDS_Face& face, const TopoDS_Edge& edge,
              const Poly_PolygonOnTriangulation& polygon, const Poly_Triangulation& part) {
    const int middle = (1 + polygon.NbNodes()) / 2;
    const gp_Pnt2d node = part.UVNode(polygon.Node(middle));
    Handle(Geom2d_Curve) nearest;
    double least = HUGE_VAL;
    for (const TopAbs_Orientation side : {TopAbs_FORWARD, TopAbs_REVERSED}) {
      double from, to;
      const Handle(Geom2d_Curve) on =
          BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Oriented(side)), face, from, to);
      const double distance = on->Value(polygon.Parameter(middle)).Distance(node);
      if (distance >= least) continue;
      least = distance;
      nearest = on;
    }
    return nearest;
  }

  void addBorderSide(std::int32_t a, std::int32_t b, BorderSide side) {
    if (a > b) std::swap(side.from, side.to);
    border_[edgeKey(a, b)] = side;
  }

  // Returns the point at a fraction of a side, on the edge or surface.
  Node at(const Side& side, const BorderSide* border, double part) const {
    if (border != nullptr) {
      // In the same order for both faces of the edge.
      const auto [from, to] = std::minmax(border->from, border->to);
      const double t = from + (border->from == from ? part : 1 - part) * (to - from);
      const BorderEdge& edge = edges_[border->edge];
      return {vectorOf(edge.curve.Value(t).XYZ()), edge.on->Value(t)};
    }
    const gp_XY &a = nodes_[side.first].on.XY(), &b = nodes_[side.second].on.XY();
    const gp_Pnt2d on(a + part * (b - a));
    return {onSurface(on), on};
  }

  Vector3d onSurface(const gp_Pnt2d& on) const {
    return vectorOf(surface_.Value(on.X(), on.Y()).XYZ());
  }

  const BorderSide* borderOf(const Side& side) const {
    const auto found = border_.find(edgeKey(side.first, side.second));
    return found == border_.end() ? nullptr : &found->second;
  }

  // Returns whether a side is too far from its edge, or from the face. The edge may be off the
  // face, by its tolerance in the file. As halving does not change that, either is compared with a
  // side between its own ends.
  bool isOff(const Side& side, double off) const {
    const Node &a = nodes_[side.first], &b = nodes_[side.second];
    const auto isFar = [off](const Vector3d& from, const Vector3d& to, const auto& pointAt) {
      const Vector3d along = to - from;
      const double square = along.squaredNorm();
      for (const double part : {0.25, 0.5, 0.75}) {  // an S has its middle on the side
        const Vector3d p = pointAt(part) - from;
        const double foot = square > 0 ? std::clamp(p.dot(along) / square, 0.0, 1.0) : 0;
        if ((p - foot * along).norm() > off) return true;
      }
      return false;
    };
    const BorderSide* border = borderOf(side);
    if (border != nullptr && edges_[border->edge].curve.GetType() != GeomAbs_Line &&
        isFar(a.at, b.at, [&](double part) { return at(side, border, part).at; }))
      return true;
    return surface_.GetType() != GeomAbs_Plane &&
           isFar(onSurface(a.on), onSurface(b.on),
                 [&](double part) { return onSurface(at(side, border, part).on); });
  }

  std::int32_t halved(const Side& side) {
    const BorderSide* known = borderOf(side);
    const auto middle = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back(at(side, known, 0.5));
    if (known != nullptr) {
      const BorderSide border = *known;
      const double t = (border.from + border.to) / 2;
      addBorderSide(side.first, middle, {border.edge, border.from, t});
      addBorderSide(side.second, middle, {border.edge, border.to, t});
    }
    return middle;
  }

  BRepAdaptor_Surface surface_;
  bool isReversed_;
  int number_;  // of the face in the shape
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
  std::vector<BorderEdge> edges_;
  std::unordered_map<std::uint64_t, BorderSide> border_;  // by edgeKey()
};

// Returns the number of triangles; more than kMaxTriangles if there would be too many.
std::size_t refine(std::vector<FaceTriangles>& faces, double accuracy) {
  // If all sides of a triangle bend equally, its middle is off by 4/3 of that.
  constexpr double kSideFraction = 0.75;
  std::atomic<std::size_t> count = 0;
  parallelBlocks(faces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      faces[i].refine(kSideFraction * accuracy, kMaxTriangles);
      count += faces[i].count();
    }
  });
  return count;
}

// Returns the kernel's triangles, face by face.
std::vector<FaceTriangles> coarseTriangles(const TopoDS_Shape& shape, double deflection) {
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape, Standard_False).Shape();
  // The mesher makes no triangles that are finer than these tolerances.
  ShapeFix_ShapeTolerance().SetTolerance(copy, Precision::Confusion());
  const ShapeTriangles coarse(copy, deflection, kAngle);
  std::vector<FaceTriangles> faces;
  for (const FaceWithTriangles& face : coarse.facesWithTriangles()) faces.emplace_back(face);
  return faces;
}

TriMesh meshOf(const std::vector<FaceTriangles>& faces) {
  TriMesh mesh;
  for (const FaceTriangles& face : faces) face.appendTo(mesh);
  return mesh;
}

}  // namespace

FineTriangles fineTriangles(const TopoDS_Shape& body, double size) {
  constexpr double kStep = 4;  // twice as many sides along a curve, and triangles at least
  std::vector<FaceTriangles> faces = coarseTriangles(body, kStart * size);
  double accuracy = kLeast * size;
  std::size_t count = refine(faces, accuracy);
  while (accuracy > kHighest * size && 2 * count <= kMaxTriangles) {
    std::vector<FaceTriangles> finer = faces;
    count = refine(finer, accuracy / kStep);
    if (count > kMaxTriangles) break;
    faces = std::move(finer);
    accuracy /= kStep;
  }
  return {meshOf(faces), accuracy};
}

TriMesh trianglesWithin(const TopoDS_Shape& shape, double distance) {
  std::vector<FaceTriangles> faces =
      coarseTriangles(shape, std::max(distance, kStart * sizeOf(shape)));
  refine(faces, distance);
  return meshOf(faces);
}

}  // namespace swept::step
