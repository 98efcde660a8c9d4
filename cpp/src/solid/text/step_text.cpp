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
  Writer(const Model& model, std::ostream& out, const SolidOptions& options, RunContext& run)
      : model_(model),
        options_(options),
        lines_(out, run),
        sections_(lines_, options),
        faceted_(isFaceted(model)) {}

  void write(const std::string& fileName) {
    sections_.header(fileName);
    vertexPoint_.reserve(model_.vertices.size());
    for (const ModelVertex& vertex : model_.vertices)
      vertexPoint_.push_back(sections_.point(vertex.point));
    if (!faceted_) {
      for (const Id p : vertexPoint_) {
        vertex_.push_back(lines_.begin("VERTEX_POINT"));
        lines_.raw("'',").id(p).end();
      }
      for (const ModelEdge& edge : model_.edges) writeEdge(edge);
    }
    std::vector<std::vector<Id>> shellFaces(model_.shellOwner.size());
    for (const ModelFace& face : model_.faces) shellFaces[face.shell].push_back(writeFace(face));
    const std::vector<Id> made = solids(shellFaces);
    const Id context = sections_.context(statedAccuracy(model_));
    std::vector<Id> items{
        sections_.placement(Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX())};
    items.insert(items.end(), made.begin(), made.end());
    sections_.product(
        faceted_ ? "FACETED_BREP_SHAPE_REPRESENTATION" : "ADVANCED_BREP_SHAPE_REPRESENTATION",
        items, made, context);
    sections_.end();
  }

 private:
  Id line(const ModelEdge& edge) {
    const Id along = sections_.direction(edge.curve.axis);
    const Id vector = lines_.begin("VECTOR");
    lines_.raw("'',").id(along).raw(",1.").end();
    const Id id = lines_.begin("LINE");
    lines_.raw("'',").id(vertexPoint_[edge.start]).raw(",").id(vector).end();
    return id;
  }

  Id circle(const Curve& curve) {
    const Id axes = sections_.placement(curve.start, curve.axis, curve.xdir);
    const Id id = lines_.begin("CIRCLE");
    lines_.raw("'',").id(axes).raw(",").length(curve.radius).end();
    return id;
  }

  Id spline(const Curve& curve) {
    std::vector<Id> poles;
    for (const Vector3d& pole : curve.poles) poles.push_back(sections_.point(pole));
    const Id id = lines_.begin("B_SPLINE_CURVE_WITH_KNOTS");
    lines_.raw("'',").raw(std::to_string(curve.degree)).raw(",").ids(poles);
    lines_.raw(",.UNSPECIFIED.,.F.,.F.,");
    multiplicities(curve.degree, curve.joints, curve.knots.size());
    lines_.raw(",");
    breaks(curve.knots);
    lines_.raw(",.UNSPECIFIED.").end();
    return id;
  }

  // Writes the multiplicities of the knots of a B-spline.
  void multiplicities(int degree, int joints, std::size_t count) {
    const std::string ends = std::to_string(degree + 1), inner = ',' + std::to_string(joints);
    lines_.raw("(").raw(ends);
    for (std::size_t i = 1; i + 1 < count; ++i) lines_.raw(inner);
    lines_.raw(",").raw(ends).raw(")");
  }
  void breaks(const std::vector<double>& knots) {
    lines_.raw("(");
    for (std::size_t i = 0; i < knots.size(); ++i) {
      if (i > 0) lines_.raw(",");
      lines_.ratio(knots[i]);
    }
    lines_.raw(")");
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
    const Carrier& s = face.surface;
    if (s.kind == CarrierKind::Facet) {
      // The corners of the facet are already written. The plane needs no particular x direction.
      const ModelUse& first = face.loops.front().front();
      const ModelEdge& edge = model_.edges[first.edge];
      const Id up = sections_.direction(s.axis);
      const Id axes = lines_.begin("AXIS2_PLACEMENT_3D");
      lines_.raw("'',").id(vertexPoint_[first.forward ? edge.start : edge.end]).raw(",").id(up);
      lines_.raw(",$").end();
      return plane(axes);
    }
    const Vector3d x = s.xdir.norm() > 0.5 ? s.xdir : anyOrthogonal(s.axis);
    if (s.kind == CarrierKind::Plane) return plane(sections_.placement(s.point, s.axis, x));
    if (s.hasProfile()) return extrusionOrRevolution(s);
    // STEP requires a positive angle, so the radius of a cone must grow along its axis.
    const bool turned = s.kind == CarrierKind::Cone && s.halfAngle < 0;
    const Id axes = sections_.placement(s.point, turned ? Vector3d(-s.axis) : s.axis, x);
    const Id id = lines_.begin(keywordOf(s.kind));
    lines_.raw("'',").id(axes).raw(",").length(s.radius);
    if (s.kind == CarrierKind::Cone) lines_.raw(",").ratio(std::abs(s.halfAngle));
    if (s.kind == CarrierKind::Torus) lines_.raw(",").length(s.minor);
    lines_.end();
    return id;
  }
  Id extrusionOrRevolution(const Carrier& s) {
    const Id profile = spline(profileOf(s)), along = sections_.direction(s.axis);
    const bool isExtrusion = s.kind == CarrierKind::Extrusion;
    const Id origin = isExtrusion ? 0 : sections_.point(s.point);
    const Id direction = lines_.begin(isExtrusion ? "VECTOR" : "AXIS1_PLACEMENT");
    if (isExtrusion) {
      lines_.raw("'',").id(along).raw(",1.").end();
    } else {
      lines_.raw("'',").id(origin).raw(",").id(along).end();
    }
    const Id id =
        lines_.begin(isExtrusion ? "SURFACE_OF_LINEAR_EXTRUSION" : "SURFACE_OF_REVOLUTION");
    lines_.raw("'',").id(profile).raw(",").id(direction).end();
    return id;
  }
  static const char* keywordOf(CarrierKind kind) {
    switch (kind) {
      case CarrierKind::Cylinder:
        return "CYLINDRICAL_SURFACE";
      case CarrierKind::Cone:
        return "CONICAL_SURFACE";
      case CarrierKind::Sphere:
        return "SPHERICAL_SURFACE";
      default:
        return "TOROIDAL_SURFACE";
    }
  }
  Id plane(Id axes) {
    const Id id = lines_.begin("PLANE");
    lines_.raw("'',").id(axes).end();
    return id;
  }

  // If the file contains only corners, a loop is written as its vertices, from which the edges
  // follow.
  Id writeFace(const ModelFace& face) {
    std::vector<Id> bounds, uses;
    for (const auto& loop : face.loops) {
      uses.clear();
      for (const ModelUse& use : loop) {
        const ModelEdge& edge = model_.edges[use.edge];
        if (faceted_) {
          uses.push_back(vertexPoint_[use.forward ? edge.start : edge.end]);
          continue;
        }
        uses.push_back(lines_.begin("ORIENTED_EDGE"));
        lines_.raw("'',*,*,").id(edge_[use.edge]).raw(use.forward ? ",.T." : ",.F.").end();
      }
      const Id ring = lines_.begin(faceted_ ? "POLY_LOOP" : "EDGE_LOOP");
      lines_.raw("'',").ids(uses).end();
      bounds.push_back(lines_.begin(face.loops.size() == 1 ? "FACE_OUTER_BOUND" : "FACE_BOUND"));
      lines_.raw("'',").id(ring).raw(",.T.").end();
    }
    const Id geometry = surface(face);
    // The surface normal of a bore points into the material. The loops follow the orientation of
    // the face, not of the surface.
    const bool against = !face.surface.isPlanar() && face.surface.reversed;
    const Id id = lines_.begin(faceted_ ? "FACE_SURFACE" : "ADVANCED_FACE");
    lines_.raw("'',").ids(bounds).raw(",").id(geometry).raw(against ? ",.F." : ",.T.").end();
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
      // The faces of a cavity already face away from the material, so the shell is not reversed.
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
  const SolidOptions& options_;
  Lines lines_;
  FileSections sections_;
  bool faceted_;
  std::vector<Id> vertexPoint_, vertex_, edge_;
};

}  // namespace

bool isFlat(const Model& model) {
  return std::all_of(model.faces.begin(), model.faces.end(),
                     [](const ModelFace& face) { return face.surface.isPlanar(); });
}

bool isFaceted(const Model& model) {
  return std::ssize(model.faces) >= kManyFaces && isFlat(model) &&
         countOuterShells(model.shellOwner) == std::ssize(model.shellOwner);
}

double statedAccuracy(const Model& model) {
  // Readers compute the gaps between surfaces themselves. If the file stated a larger value, they
  // could drop short edges, and accept curves that lie off their surfaces by this distance.
  if (!isFlat(model)) return kKernelTolerance;
  double largest = kKernelTolerance;
  for (const ModelVertex& vertex : model.vertices) largest = std::max(largest, vertex.tolerance);
  // Slightly larger than measured, because the file rounds points and directions.
  return 1.02 * largest + 1e-8;
}

void writeStepText(const Model& model, std::ostream& out, const std::string& fileName,
                   const SolidOptions& options, RunContext& run) {
  Writer(model, out, options, run).write(fileName);
}

}  // namespace swept::step
