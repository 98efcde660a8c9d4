// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text/step_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solid/text/step_lines.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

class Writer {
 public:
  Writer(const Model& model, std::ostream& out, const StepOptions& options, RunContext& run)
      : model_(model),
        options_(options),
        lines_(out, run),
        frame_(lines_, options),
        faceted_(isFaceted(model)) {}

  void write(const std::string& fileName) {
    frame_.header(fileName);
    vertexPoint_.reserve(model_.vertices.size());
    for (const ModelVertex& vertex : model_.vertices)
      vertexPoint_.push_back(frame_.point(vertex.point));
    if (!faceted_) {
      for (const Id p : vertexPoint_) {
        vertex_.push_back(lines_.begin("VERTEX_POINT"));
        lines_.raw("'',").id(p).end();
      }
      for (const ModelEdge& edge : model_.edges) writeEdge(edge);
    }
    std::vector<std::vector<Id>> shellFaces(model_.shellOwner.size());
    for (const ModelFace& face : model_.faces)
      shellFaces[face.shell].push_back(faceted_ ? writeFacet(face) : writeFace(face));
    const std::vector<Id> made = solids(shellFaces);
    const Id context = frame_.context(statedAccuracy(model_));
    std::vector<Id> items{frame_.placement(Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX())};
    items.insert(items.end(), made.begin(), made.end());
    frame_.product(
        faceted_ ? "FACETED_BREP_SHAPE_REPRESENTATION" : "ADVANCED_BREP_SHAPE_REPRESENTATION",
        items, made, context);
    frame_.end();
  }

 private:
  Id line(const ModelEdge& edge) {
    const Id along = frame_.direction(edge.curve.axis);
    const Id vector = lines_.begin("VECTOR");
    lines_.raw("'',").id(along).raw(",1.").end();
    const Id id = lines_.begin("LINE");
    lines_.raw("'',").id(vertexPoint_[edge.start]).raw(",").id(vector).end();
    return id;
  }

  Id circle(const Curve& curve) {
    const Id frame = frame_.placement(curve.start, curve.axis, curve.xdir);
    const Id id = lines_.begin("CIRCLE");
    lines_.raw("'',").id(frame).raw(",").length(curve.radius).end();
    return id;
  }

  Id spline(const Curve& curve) {
    std::vector<Id> poles;
    for (const Vector3d& pole : curve.poles) poles.push_back(frame_.point(pole));
    const Id id = lines_.begin("B_SPLINE_CURVE_WITH_KNOTS");
    lines_.raw("'',3,").ids(poles).raw(",.UNSPECIFIED.,.F.,.F.,(");
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
      lines_.raw(i == 0 ? "4" : i + 1 == curve.knots.size() ? ",4" : ",2");
    }
    lines_.raw("),(");
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
      if (i > 0) lines_.raw(",");
      lines_.ratio(curve.knots[i]);
    }
    lines_.raw("),.UNSPECIFIED.").end();
    return id;
  }

  Id curve(const ModelEdge& edge) {
    switch (edge.curve.kind) {
      case CurveKind::Circle:
        return circle(edge.curve);
      case CurveKind::Spline:
        return spline(edge.curve);
      default:
        return line(edge);
    }
  }

  void writeEdge(const ModelEdge& edge) {
    const Id geometry = curve(edge);
    edge_.push_back(lines_.begin("EDGE_CURVE"));
    lines_.raw("'',").id(vertex_[edge.start]).raw(",").id(vertex_[edge.end]).raw(",").id(geometry);
    lines_.raw(",.T.").end();
  }

  Id surface(const ModelFace& face) {
    const Surface& s = face.surface;
    if (s.kind == SurfaceKind::Facet) {
      // Its corners are written already, and where its own x direction lies is nobody's concern.
      const ModelUse& first = face.loops.front().front();
      const ModelEdge& edge = model_.edges[first.edge];
      const Id up = frame_.direction(s.axis);
      const Id frame = lines_.begin("AXIS2_PLACEMENT_3D");
      lines_.raw("'',").id(vertexPoint_[first.forward ? edge.start : edge.end]).raw(",").id(up);
      lines_.raw(",$").end();
      return plane(frame);
    }
    const Vector3d x = s.xdir.norm() > 0.5 ? s.xdir : anyOrthogonal(s.axis);
    if (s.kind == SurfaceKind::Plane) return plane(frame_.placement(s.point, s.axis, x));
    if (s.hasProfile()) return pushedOrTurned(s);
    // The angle of a cone is positive: the radius grows along its axis.
    const bool turned = s.kind == SurfaceKind::Cone && s.halfAngle < 0;
    const Id frame = frame_.placement(s.point, turned ? Vector3d(-s.axis) : s.axis, x);
    const Id id = lines_.begin(keywordOf(s.kind));
    lines_.raw("'',").id(frame).raw(",").length(s.radius);
    if (s.kind == SurfaceKind::Cone) lines_.raw(",").ratio(std::abs(s.halfAngle));
    if (s.kind == SurfaceKind::Torus) lines_.raw(",").length(s.minor);
    lines_.end();
    return id;
  }
  Id pushedOrTurned(const Surface& s) {
    const Id profile = spline(profileOf(s)), along = frame_.direction(s.axis);
    const bool pushed = s.kind == SurfaceKind::Extrusion;
    const Id origin = pushed ? 0 : frame_.point(s.point);
    const Id way = lines_.begin(pushed ? "VECTOR" : "AXIS1_PLACEMENT");
    if (pushed) {
      lines_.raw("'',").id(along).raw(",1.").end();
    } else {
      lines_.raw("'',").id(origin).raw(",").id(along).end();
    }
    const Id id = lines_.begin(pushed ? "SURFACE_OF_LINEAR_EXTRUSION" : "SURFACE_OF_REVOLUTION");
    lines_.raw("'',").id(profile).raw(",").id(way).end();
    return id;
  }
  static const char* keywordOf(SurfaceKind kind) {
    switch (kind) {
      case SurfaceKind::Cylinder:
        return "CYLINDRICAL_SURFACE";
      case SurfaceKind::Cone:
        return "CONICAL_SURFACE";
      case SurfaceKind::Sphere:
        return "SPHERICAL_SURFACE";
      default:
        return "TOROIDAL_SURFACE";
    }
  }
  Id plane(Id frame) {
    const Id id = lines_.begin("PLANE");
    lines_.raw("'',").id(frame).end();
    return id;
  }

  Id writeFace(const ModelFace& face) {
    std::vector<Id> bounds, uses;
    for (const auto& loop : face.loops) {
      uses.clear();
      for (const ModelUse& use : loop) {
        uses.push_back(lines_.begin("ORIENTED_EDGE"));
        lines_.raw("'',*,*,").id(edge_[use.edge]).raw(use.forward ? ",.T." : ",.F.").end();
      }
      const Id ring = lines_.begin("EDGE_LOOP");
      lines_.raw("'',").ids(uses).end();
      bounds.push_back(lines_.begin(face.loops.size() == 1 ? "FACE_OUTER_BOUND" : "FACE_BOUND"));
      lines_.raw("'',").id(ring).raw(",.T.").end();
    }
    const Id geometry = surface(face);
    // A bore's surface looks into the material; loops run as its face sees them.
    const bool against = !face.surface.isPlanar() && face.surface.reversed;
    const Id id = lines_.begin("ADVANCED_FACE");
    lines_.raw("'',").ids(bounds).raw(",").id(geometry).raw(against ? ",.F." : ",.T.").end();
    return id;
  }

  // The corners alone; the edges between them follow.
  Id writeFacet(const ModelFace& face) {
    std::vector<Id> bounds, corners;
    for (const auto& loop : face.loops) {
      corners.clear();
      for (const ModelUse& use : loop) {
        const ModelEdge& edge = model_.edges[use.edge];
        corners.push_back(vertexPoint_[use.forward ? edge.start : edge.end]);
      }
      const Id ring = lines_.begin("POLY_LOOP");
      lines_.raw("'',").ids(corners).end();
      bounds.push_back(lines_.begin(face.loops.size() == 1 ? "FACE_OUTER_BOUND" : "FACE_BOUND"));
      lines_.raw("'',").id(ring).raw(",.T.").end();
    }
    const Id geometry = surface(face);
    const Id id = lines_.begin("FACE_SURFACE");
    lines_.raw("'',").ids(bounds).raw(",").id(geometry).raw(",.T.").end();
    return id;
  }

  std::vector<Id> solids(const std::vector<std::vector<Id>>& shellFaces) {
    std::vector<Id> shells;
    for (const auto& faces : shellFaces) {
      shells.push_back(lines_.begin("CLOSED_SHELL"));
      lines_.raw("'',").ids(faces).end();
    }
    std::vector<std::vector<Id>> voids(shells.size());
    for (std::size_t s = 0; s < shells.size(); ++s) {
      const std::int32_t owner = model_.shellOwner[s];
      if (owner == static_cast<std::int32_t>(s)) continue;
      // The faces of a void already look away from the material.
      voids[owner].push_back(lines_.begin("ORIENTED_CLOSED_SHELL"));
      lines_.raw("'',*,").id(shells[s]).raw(",.T.").end();
    }
    std::vector<Id> result;
    for (std::size_t s = 0; s < shells.size(); ++s) {
      if (model_.shellOwner[s] != static_cast<std::int32_t>(s)) continue;
      result.push_back(lines_.begin(faceted_           ? "FACETED_BREP"
                                    : voids[s].empty() ? "MANIFOLD_SOLID_BREP"
                                                       : "BREP_WITH_VOIDS"));
      lines_.raw(stepString(options_.productName)).raw(",").id(shells[s]);
      if (!voids[s].empty()) lines_.raw(",").ids(voids[s]);
      lines_.end();
    }
    return result;
  }

  const Model& model_;
  const StepOptions& options_;
  Lines lines_;
  Frame frame_;
  bool faceted_;
  std::vector<Id> vertexPoint_, vertex_, edge_;
};

}  // namespace

bool isFlat(const Model& model) {
  return std::all_of(model.faces.begin(), model.faces.end(),
                     [](const ModelFace& face) { return face.surface.isPlanar(); });
}

bool isFaceted(const Model& model) {
  if (static_cast<std::int64_t>(model.faces.size()) < kManyFaces || !isFlat(model)) return false;
  for (std::size_t s = 0; s < model.shellOwner.size(); ++s) {
    if (model.shellOwner[s] != static_cast<std::int32_t>(s)) return false;
  }
  return true;
}

double statedAccuracy(const Model& model) {
  // Between surfaces readers find the gaps themselves; a wide figure would let them drop short
  // edges.
  if (!isFlat(model)) return 1e-6;
  double largest = 1e-7;
  for (const ModelVertex& vertex : model.vertices) largest = std::max(largest, vertex.tolerance);
  // A little more than was measured: the file rounds points and directions.
  return 1.02 * largest + 1e-8;
}

void writeStepText(const Model& model, std::ostream& out, const std::string& fileName,
                   const StepOptions& options, RunContext& run) {
  Writer(model, out, options, run).write(fileName);
}

}  // namespace swept::step
