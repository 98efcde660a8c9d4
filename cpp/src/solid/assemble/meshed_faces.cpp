// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/meshed_faces.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/segment_triangle.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/zero_curves.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct MeshedFaces::FoundPiercing {
  // Face and two nodes of the edge, face and triangle. A shared node has the face -1.
  std::tuple<int, int, int, int, int> key;
  Piercing piercing;
};

// The piercings of two faces, and the segments that join two of them each.
struct MeshedFaces::PairChains {
  std::map<std::tuple<int, int, int, int, int>, int> index;
  std::vector<Piercing> piercings;
  std::vector<std::array<int, 2>> segments;

  int add(const FoundPiercing& found) {
    const auto [it, isNew] = index.emplace(found.key, static_cast<int>(piercings.size()));
    if (isNew) piercings.push_back(found.piercing);
    return it->second;
  }

  // Follows the segments from piercing to piercing; first from ends and branches.
  std::vector<std::vector<Piercing>> follow() const {
    std::vector<std::vector<int>> at(piercings.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
      for (const int p : segments[s]) at[p].push_back(static_cast<int>(s));
    }
    std::vector<char> used(segments.size());
    std::vector<std::vector<Piercing>> chains;
    for (const bool isOpen : {true, false}) {
      for (std::size_t p = 0; p < at.size(); ++p) {
        if (isOpen && at[p].size() == 2) continue;
        for (const int first : at[p]) {
          if (used[first]) continue;
          std::vector<Piercing>& chain = chains.emplace_back(1, piercings[p]);
          int here = static_cast<int>(p), segment = first;
          while (!used[segment]) {
            used[segment] = 1;
            here = segments[segment][segments[segment][0] == here ? 1 : 0];
            chain.push_back(piercings[here]);
            if (at[here].size() != 2) break;
            segment = used[at[here][0]] ? at[here][1] : at[here][0];
          }
        }
      }
    }
    return chains;
  }
};

MeshedFaces::MeshedFaces(const std::vector<SweptFace>& faces, double deflection)
    : given_(faces), deflection_(deflection) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const SweptFace& face : faces) builder.Add(all, face.face);
  constexpr double kMeshAngle = 0.1;
  BRepMesh_IncrementalMesh(all, deflection, Standard_False, kMeshAngle, Standard_True);
  for (TopExp_Explorer it(all, TopAbs_EDGE); it.More(); it.Next()) {
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) edges_.Add(it.Current());
  }
  for (const SweptFace& face : faces) {
    for (const TopoDS_Edge& edge : face.inner) edges_.Add(edge);
  }
  std::map<std::array<long long, 3>, int> nodes;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    faces_.push_back(meshOf(faces[f].face, nodes));
    for (const TopoDS_Edge& edge : faces[f].inner) faces_[f].edges.insert(edges_.FindIndex(edge));
    for (std::size_t t = 0; t < faces_[f].triangles.size(); ++t)
      triangles_.emplace_back(static_cast<int>(f), static_cast<int>(t));
  }
  tree_ = BoxTree(triangles_.size(), [&](std::size_t i) { return boxOf(triangles_[i]); });
}

// Appends the parts of a border of a face.
void MeshedFaces::appendParts(const TopoDS_Face& face, const TopoDS_Edge& edge,
                              std::vector<BorderPart>& to) {
  BorderPart whole;
  whole.curve = BRep_Tool::CurveOnSurface(edge, face, whole.range[0], whole.range[1]);
  if (whole.curve.IsNull()) return;
  whole.isStraight = Geom2dAdaptor_Curve(whole.curve).GetType() == GeomAbs_Line;
  std::vector<double> ends{whole.range[0]};
  if (!whole.isStraight) {
    const OfOne slope = [&](double t) {
      gp_Pnt2d p;
      gp_Vec2d along;
      whole.curve->D1(t, p, along);
      return along.Y();
    };
    const std::vector<double> turns = zerosOf(slope, {whole.range[0], whole.range[1]});
    ends.insert(ends.end(), turns.begin(), turns.end());
  }
  ends.push_back(whole.range[1]);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    BorderPart& part = to.emplace_back(whole);
    part.range = {ends[i], ends[i + 1]};
    for (const int k : {0, 1}) {
      const gp_Pnt2d p = whole.curve->Value(part.range[k]);
      part.ends[k] = {p.X(), p.Y()};
    }
  }
}

MeshedFaces::Meshed MeshedFaces::meshOf(const TopoDS_Face& face,
                                        std::map<std::array<long long, 3>, int>& nodes) const {
  Meshed mesh;
  mesh.surface = BRep_Tool::Surface(face);
  TopLoc_Location place;
  const Handle(Poly_Triangulation) made = BRep_Tool::Triangulation(face, place);
  if (made.IsNull()) return mesh;
  for (int i = 1; i <= made->NbNodes(); ++i) {
    const Vector3d p = vectorOf(made->Node(i).Transformed(place.Transformation()).XYZ());
    mesh.nodes.push_back(p);
    mesh.parameters.emplace_back(made->UVNode(i).X(), made->UVNode(i).Y());
    mesh.range.extend(mesh.parameters.back());
    constexpr double kSame = 1e-6;  // mm
    std::array<long long, 3> cell;
    for (int k = 0; k < 3; ++k) cell[k] = std::llround(p[k] / kSame);
    mesh.shared.push_back(nodes.emplace(cell, static_cast<int>(nodes.size())).first->second);
  }
  for (int i = 1; i <= made->NbTriangles(); ++i) {
    int a, b, c;
    made->Triangle(i).Get(a, b, c);
    mesh.triangles.push_back({a - 1, b - 1, c - 1});
  }
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    appendParts(face, TopoDS::Edge(it.Current()), mesh.parts);
    const int e = edges_.FindIndex(it.Current());
    if (e == 0) continue;  // degenerated
    mesh.edges.insert(e);
    const auto polygon = BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(it.Current()), made, place);
    if (polygon.IsNull()) continue;
    const TColStd_Array1OfInteger& along = polygon->Nodes();
    for (int i = along.Lower(); i < along.Upper(); ++i)
      mesh.borders[std::minmax(along(i) - 1, along(i + 1) - 1)] = e;
  }
  return mesh;
}

BoxTree::Bounds MeshedFaces::boxOf(const Triangle& t) const {
  BoxTree::Bounds box;
  for (const int n : corners(t)) box.extend(faces_[t.first].nodes[n]);
  return box;
}

std::vector<Vector3d> MeshedFaces::commonVertices(int f, int g) const {
  std::vector<Vector3d> common;
  const bool haveEdge = std::any_of(faces_[f].edges.begin(), faces_[f].edges.end(),
                                    [&](int e) { return hasEdge(g, e); });
  if (!haveEdge) return common;
  TopTools_IndexedMapOfShape vertices, others;
  for (const int e : faces_[f].edges) TopExp::MapShapes(edges_(e), TopAbs_VERTEX, vertices);
  for (const int e : faces_[g].edges) TopExp::MapShapes(edges_(e), TopAbs_VERTEX, others);
  for (int v = 1; v <= others.Extent(); ++v) {
    if (vertices.Contains(others(v)))
      common.push_back(vectorOf(BRep_Tool::Pnt(TopoDS::Vertex(others(v))).XYZ()));
  }
  return common;
}

bool MeshedFaces::areOfOneGroup(int f, int g) const {
  return given_[f].group != SweptFace::kAlone && given_[f].group == given_[g].group;
}

Jet MeshedFaces::jet(int f, const Vector2d& on) const {
  gp_Pnt p;
  gp_Vec u, v;
  faces_[f].surface->D1(on.x(), on.y(), p, u, v);
  return {vectorOf(p.XYZ()), vectorOf(u.XYZ()), vectorOf(v.XYZ())};
}

double MeshedFaces::BorderPart::uAt(double v) const {
  const double fraction = (v - ends[0].y()) / (ends[1].y() - ends[0].y());
  if (isStraight) return ends[0].x() + fraction * (ends[1].x() - ends[0].x());
  const OfOne below = [&](double t) { return v - curve->Value(t).Y(); };
  return curve->Value(zeroBetween(below, range[0], range[1])).X();
}

bool MeshedFaces::isInFace(int f, const Vector2d& on) const {
  // Counts the parts of the border between the point and a point far away.
  bool isInside = false;
  for (const BorderPart& part : faces_[f].parts) {
    if ((part.ends[0].y() <= on.y()) != (part.ends[1].y() <= on.y()))
      isInside ^= part.uAt(on.y()) > on.x();
  }
  return isInside;
}

bool MeshedFaces::isPossible(int f, const Vector2d& on) const {
  // Curves of intersection that cannot be on the envelope still show where others end. Only if
  // there are many faces is it worth while to do without them: it halves the time of a pulley with
  // 462.
  constexpr std::size_t kManyFaces = 100;
  constexpr double kSure = 1e-3;
  // Where faces overlap, their triangulations intersect at random.
  if (!doesOwn(f, on)) return false;
  return faces_.size() < kManyFaces || given_[f].isPossible(on, kSure);
}

bool MeshedFaces::doesOwn(int f, const Vector2d& on) const {
  return !given_[f].own || given_[f].own(on) >= 0;
}

bool MeshedFaces::isInRange(int f, const Vector2d& on) const {
  constexpr double kSlack = 1e-3;  // of the range
  const Eigen::AlignedBox2d& range = faces_[f].range;
  const Vector2d slack = kSlack * range.sizes();
  return ((on - range.min() + slack).array() >= 0).all() &&
         ((range.max() + slack - on).array() >= 0).all();
}

Handle(Geom2d_Curve) MeshedFaces::curveOn(int f, const TopoDS_Edge& edge) const {
  double from, to;
  return BRep_Tool::CurveOnSurface(edge, face(f), from, to);
}

// Appends the piercings of edges of triangle s with triangle t. `side`: which face s is of.
void MeshedFaces::pierceEdges(const Triangle& s, const Triangle& t, int side, int sharedNode,
                              std::vector<FoundPiercing>& to) const {
  const Meshed &f = faces_[s.first], &g = faces_[t.first];
  const std::array<int, 3>&ends = corners(s), &other = corners(t);
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax(ends[k], ends[(k + 1) % 3]);
    if (sharedNode >= 0 && (f.shared[low] == sharedNode || f.shared[high] == sharedNode)) continue;
    const auto hit = throughTriangle(f.nodes[low], f.nodes[high], g.nodes[other[0]],
                                     g.nodes[other[1]], g.nodes[other[2]]);
    if (!hit) continue;
    FoundPiercing& found = to.emplace_back();
    found.key = {s.first, low, high, t.first, t.second};
    const double w = (*hit)[0], v1 = (*hit)[1], v2 = (*hit)[2];
    found.piercing.at = f.nodes[low] + w * (f.nodes[high] - f.nodes[low]);
    found.piercing.on[side] = f.parameters[low] + w * (f.parameters[high] - f.parameters[low]);
    found.piercing.on[1 - side] = (1 - v1 - v2) * g.parameters[other[0]] +
                                  v1 * g.parameters[other[1]] + v2 * g.parameters[other[2]];
    const auto border = f.borders.find({low, high});
    if (border == f.borders.end()) continue;
    found.piercing.border = border->second;
    found.piercing.borderSide = side;
    if (g.edges.count(border->second) != 0) to.pop_back();  // it lies on the other face, too
  }
}

std::vector<MeshedFaces::FoundPiercing> MeshedFaces::piercingsOf(const Triangle& s,
                                                                 const Triangle& t) const {
  const Meshed &f = faces_[s.first], &g = faces_[t.first];
  std::vector<FoundPiercing> found;
  std::vector<std::pair<int, int>> common;
  for (const int a : corners(s)) {
    for (const int b : corners(t)) {
      if (f.shared[a] == g.shared[b]) common.emplace_back(a, b);
    }
  }
  if (common.size() > 1) return found;
  const int node = common.empty() ? -1 : f.shared[common.front().first];
  pierceEdges(s, t, 0, node, found);
  pierceEdges(t, s, 1, node, found);
  if (node >= 0 && found.size() == 1) {
    FoundPiercing& end = found.emplace_back();
    const auto [a, b] = common.front();
    end.key = {-1, node, 0, 0, 0};
    end.piercing.isNode = true;
    end.piercing.at = f.nodes[a];
    end.piercing.on = {f.parameters[a], g.parameters[b]};
  }
  return found;
}

std::vector<FaceChain> MeshedFaces::chains() const {
  std::map<std::pair<int, int>, PairChains> pairs;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& s = triangles_[i];
    const BoxTree::Bounds box = boxOf(s);
    tree_.forBox(box.low, box.high, [&](std::uint32_t place) {
      const std::size_t j = tree_.item(place);
      const Triangle& t = triangles_[j];
      if (j <= i || t.first == s.first || areOfOneGroup(s.first, t.first)) return;
      const std::vector<FoundPiercing> found = piercingsOf(s, t);
      if (found.size() != 2) return;
      PairChains& pair = pairs[{s.first, t.first}];
      const int from = pair.add(found[0]), to = pair.add(found[1]);
      pair.segments.push_back({from, to});
    });
  }
  std::vector<FaceChain> result;
  for (const auto& [faces, pair] : pairs) {
    for (std::vector<Piercing>& chain : pair.follow())
      result.push_back({faces.first, faces.second, std::move(chain)});
  }
  return result;
}

std::map<int, Vector2d> MeshedFaces::near(const Vector3d& from, const Vector3d& to) const {
  std::map<int, Vector2d> result;
  std::map<int, double> distances;
  constexpr double kNearby = 4;  // times the deflection
  const Vector3d margin = Vector3d::Constant(kNearby * deflection_), middle = (from + to) / 2;
  tree_.forBox(from.cwiseMin(to) - margin, from.cwiseMax(to) + margin, [&](std::uint32_t place) {
    const Triangle& t = triangles_[tree_.item(place)];
    const Meshed& mesh = faces_[t.first];
    Vector3d centre = Vector3d::Zero();
    Vector2d on = Vector2d::Zero();
    for (const int n : corners(t)) {
      centre += mesh.nodes[n] / 3;
      on += mesh.parameters[n] / 3;
    }
    const double distance = (centre - middle).norm();
    const auto [it, isNew] = distances.emplace(t.first, distance);
    if (!isNew && it->second <= distance) return;
    it->second = distance;
    result[t.first] = on;
  });
  return result;
}

}  // namespace swept::step
