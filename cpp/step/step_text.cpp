// SPDX-License-Identifier: LGPL-2.1-or-later
#include "step_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <initializer_list>
#include <vector>

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kPointDecimals = 9;
constexpr int kDirectionDigits = 13;
constexpr std::size_t kFlushAt = 1U << 20U;

using Id = std::int64_t;

// One line of the data section after another, numbered as they come.
class Lines {
 public:
  Lines(std::ostream& out, RunContext& run) : out_(out), run_(run) { text_.reserve(2 * kFlushAt); }

  /// Starts `#n=`; what follows is appended, end() closes the line.
  Id begin(const char* keyword) {
    text_ += '#';
    integer(++last_);
    text_ += '=';
    text_ += keyword;
    text_ += '(';
    return last_;
  }
  void end() {
    text_ += ");\n";
    flushIfLong();
  }
  Lines& raw(const char* words) {
    text_ += words;
    return *this;
  }
  Lines& raw(const std::string& words) {
    text_ += words;
    return *this;
  }
  Lines& id(Id value) {
    text_ += '#';
    integer(value);
    return *this;
  }
  Lines& ids(const std::vector<Id>& values) {
    text_ += '(';
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) text_ += ',';
      id(values[i]);
    }
    text_ += ')';
    return *this;
  }
  Lines& length(double value) { return real(value, std::chars_format::fixed, kPointDecimals); }
  Lines& ratio(double value) { return real(value, std::chars_format::general, kDirectionDigits); }
  Lines& triple(const Vector3d& v, bool isPoint) {
    text_ += '(';
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text_ += ',';
      isPoint ? length(v[k]) : ratio(v[k]);
    }
    text_ += ')';
    return *this;
  }
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    run_.checkpoint(Phase::Export);
  }
  Id last() const { return last_; }

 private:
  void integer(Id value) {
    std::array<char, 24> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text_.append(buffer.data(), end);
  }
  // A real of STEP has a point, and a capital E.
  Lines& real(double value, std::chars_format format, int precision) {
    std::array<char, 400> buffer;
    char* end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0, format, precision)
            .ptr;
    char* point = nullptr;
    char* exponent = nullptr;
    for (char* c = buffer.data(); c != end; ++c) {
      if (*c == '.') point = c;
      if (*c == 'e') {
        *c = 'E';
        exponent = c;
      }
    }
    if (point != nullptr && exponent == nullptr) {
      while (end[-1] == '0') --end;
    }
    const std::size_t start = text_.size();
    text_.append(buffer.data(), end);
    if (point == nullptr) {
      const std::size_t at =
          exponent == nullptr ? text_.size() : start + (exponent - buffer.data());
      text_.insert(at, 1, '.');
    }
    return *this;
  }
  void flushIfLong() {
    if (text_.size() > kFlushAt) flush();
  }

  std::ostream& out_;
  RunContext& run_;
  std::string text_;
  Id last_ = 0;
};

class Writer {
 public:
  Writer(const Model& model, std::ostream& out, const StepOptions& options, RunContext& run)
      : model_(model), options_(options), lines_(out, run), faceted_(isFaceted(model)) {}

  void write(const std::string& fileName) {
    header(fileName);
    vertexPoint_.reserve(model_.vertices.size());
    for (const ModelVertex& vertex : model_.vertices) vertexPoint_.push_back(point(vertex.point));
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
    product(solids(shellFaces));
    lines_.raw("ENDSEC;\nEND-ISO-10303-21;\n").flush();
  }

 private:
  bool is242() const { return options_.schema == StepSchema::Ap242; }

  void header(const std::string& fileName) {
    std::array<char, 32> date{};
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
    lines_.raw("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((");
    lines_.raw(stepString("Envelope of a moving body: " + options_.productName));
    lines_.raw("),'2;1');\nFILE_NAME(").raw(stepString(fileName)).raw(",'").raw(date.data());
    lines_.raw("',(").raw(stepString(options_.author)).raw("),(");
    lines_.raw(stepString(options_.organization));
    lines_.raw("),'Swept Volume','Swept Volume for FreeCAD','');\nFILE_SCHEMA(('");
    lines_.raw(is242() ? "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }"
                       : "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 }");
    lines_.raw("'));\nENDSEC;\nDATA;\n");
  }

  Id point(const Vector3d& p) {
    const Id id = lines_.begin("CARTESIAN_POINT");
    lines_.raw("'',").triple(p, true).end();
    return id;
  }
  Id direction(const Vector3d& d) {
    const Id id = lines_.begin("DIRECTION");
    lines_.raw("'',").triple(d, false).end();
    return id;
  }
  Id placement(const Vector3d& origin, const Vector3d& axis, const Vector3d& x) {
    const Id at = point(origin), up = direction(axis), across = direction(x);
    const Id id = lines_.begin("AXIS2_PLACEMENT_3D");
    lines_.raw("'',").id(at).raw(",").id(up).raw(",").id(across).end();
    return id;
  }

  Id line(const ModelEdge& edge) {
    const Id along = direction(edge.curve.axis);
    const Id vector = lines_.begin("VECTOR");
    lines_.raw("'',").id(along).raw(",1.").end();
    const Id id = lines_.begin("LINE");
    lines_.raw("'',").id(vertexPoint_[edge.start]).raw(",").id(vector).end();
    return id;
  }

  Id circle(const Curve& curve) {
    const Id frame = placement(curve.start, curve.axis, curve.xdir);
    const Id id = lines_.begin("CIRCLE");
    lines_.raw("'',").id(frame).raw(",").length(curve.radius).end();
    return id;
  }

  Id spline(const Curve& curve) {
    std::vector<Id> poles;
    for (const Vector3d& pole : curve.poles) poles.push_back(point(pole));
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
      const Id up = direction(s.axis);
      const Id frame = lines_.begin("AXIS2_PLACEMENT_3D");
      lines_.raw("'',").id(vertexPoint_[first.forward ? edge.start : edge.end]).raw(",").id(up);
      lines_.raw(",$").end();
      return plane(frame);
    }
    const Vector3d x = s.xdir.norm() > 0.5 ? s.xdir : anyOrthogonal(s.axis);
    if (s.kind == SurfaceKind::Plane) return plane(placement(s.point, s.axis, x));
    if (s.hasProfile()) return pushedOrTurned(s);
    // The angle of a cone is positive: the radius grows along its axis.
    const bool turned = s.kind == SurfaceKind::Cone && s.halfAngle < 0;
    const Id frame = placement(s.point, turned ? Vector3d(-s.axis) : s.axis, x);
    const Id id = lines_.begin(keywordOf(s.kind));
    lines_.raw("'',").id(frame).raw(",").length(s.radius);
    if (s.kind == SurfaceKind::Cone) lines_.raw(",").ratio(std::abs(s.halfAngle));
    if (s.kind == SurfaceKind::Torus) lines_.raw(",").length(s.minor);
    lines_.end();
    return id;
  }
  Id pushedOrTurned(const Surface& s) {
    const Id profile = spline(profileOf(s)), along = direction(s.axis);
    const bool pushed = s.kind == SurfaceKind::Extrusion;
    const Id origin = pushed ? 0 : point(s.point);
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

  using Words = std::initializer_list<std::string>;
  Id plain(const char* keyword, Words arguments) {
    const Id id = lines_.begin(keyword);
    for (const std::string& word : arguments) lines_.raw(word);
    lines_.end();
    return id;
  }
  static std::string ref(Id id) {
    std::string text = std::to_string(id);
    text.insert(text.begin(), '#');
    return text;
  }

  // An entity of several types at once has its keywords inside the brackets.
  Id context() {
    const Id mm = plain("", {"LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.)"});
    const Id radian = plain("", {"NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.)"});
    const Id steradian = plain("", {"NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT()"});
    const Id accuracy = lines_.begin("UNCERTAINTY_MEASURE_WITH_UNIT");
    lines_.raw("LENGTH_MEASURE(").ratio(statedAccuracy(model_)).raw("),").id(mm);
    lines_.raw(",'distance_accuracy_value','confusion accuracy'").end();
    return plain("", {"GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((",
                      ref(accuracy), ")) GLOBAL_UNIT_ASSIGNED_CONTEXT((", ref(mm), ",", ref(radian),
                      ",", ref(steradian), ")) REPRESENTATION_CONTEXT('Context #1',",
                      "'3D Context with UNIT and UNCERTAINTY')"});
  }

  void product(const std::vector<Id>& solidIds) {
    const Id where = context();
    const Id origin = placement(Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX());
    std::vector<Id> items{origin};
    items.insert(items.end(), solidIds.begin(), solidIds.end());
    const std::string name = stepString(options_.productName);
    const Id shape = lines_.begin(faceted_ ? "FACETED_BREP_SHAPE_REPRESENTATION"
                                           : "ADVANCED_BREP_SHAPE_REPRESENTATION");
    lines_.raw(name).raw(",").ids(items).raw(",").id(where).end();
    const Id application =
        plain("APPLICATION_CONTEXT", {is242() ? "'managed model based 3d engineering'"
                                              : "'core data for automotive mechanical design "
                                                "processes'"});
    plain(
        "APPLICATION_PROTOCOL_DEFINITION",
        {"'international standard',",
         is242() ? "'ap242_managed_model_based_3d_engineering',2014," : "'automotive_design',2000,",
         ref(application)});
    const Id productContext = plain("PRODUCT_CONTEXT", {"'',", ref(application), ",'mechanical'"});
    const Id thing = plain("PRODUCT", {name, ",", name, ",'',(", ref(productContext), ")"});
    plain("PRODUCT_RELATED_PRODUCT_CATEGORY", {"'part',$,(", ref(thing), ")"});
    const Id formation = plain("PRODUCT_DEFINITION_FORMATION", {"'','',", ref(thing)});
    const Id design =
        plain("PRODUCT_DEFINITION_CONTEXT", {"'part definition',", ref(application), ",'design'"});
    const Id definition =
        plain("PRODUCT_DEFINITION", {"'design','',", ref(formation), ",", ref(design)});
    const Id definitionShape = plain("PRODUCT_DEFINITION_SHAPE", {"'','',", ref(definition)});
    plain("SHAPE_DEFINITION_REPRESENTATION", {ref(definitionShape), ",", ref(shape)});
    colour(solidIds, where);
  }

  void colour(const std::vector<Id>& solidIds, Id where) {
    const Id paint = lines_.begin("COLOUR_RGB");
    lines_.raw("''");
    for (const double part : options_.colour) lines_.raw(",").ratio(part);
    lines_.end();
    const Id fillColour = plain("FILL_AREA_STYLE_COLOUR", {"'',", ref(paint)});
    const Id fill = plain("FILL_AREA_STYLE", {"'',(", ref(fillColour), ")"});
    const Id area = plain("SURFACE_STYLE_FILL_AREA", {ref(fill)});
    const Id side = plain("SURFACE_SIDE_STYLE", {"'',(", ref(area), ")"});
    const Id usage = plain("SURFACE_STYLE_USAGE", {".BOTH.,", ref(side)});
    const Id style = plain("PRESENTATION_STYLE_ASSIGNMENT", {"(", ref(usage), ")"});
    std::vector<Id> styled;
    for (const Id solid : solidIds) {
      styled.push_back(plain("STYLED_ITEM", {"'color',(", ref(style), "),", ref(solid)}));
    }
    lines_.begin("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION");
    lines_.raw("'',").ids(styled).raw(",").id(where).end();
  }

  const Model& model_;
  const StepOptions& options_;
  Lines lines_;
  bool faceted_;
  std::vector<Id> vertexPoint_, vertex_, edge_;
};

// The code point at `at`, which moves on; a byte that is not UTF-8 stands for itself.
char32_t codePoint(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  if (at + static_cast<std::size_t>(more) >= text.size()) return byte(at++);
  char32_t value = more == 0 ? first : first & (0x3FU >> more);
  for (int k = 1; k <= more; ++k) value = (value << 6U) | (byte(at + k) & 0x3FU);
  at += more + 1;
  return value;
}

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

std::string stepString(const std::string& utf8) {
  std::string result = "'";
  for (std::size_t at = 0; at < utf8.size();) {
    const char32_t c = codePoint(utf8, at);
    if (c == '\'' || c == '\\') {
      result.append(2, static_cast<char>(c));
    } else if (c >= 0x20 && c < 0x7F) {
      result += static_cast<char>(c);
    } else {
      std::array<char, 24> code{};
      std::snprintf(code.data(), code.size(), c > 0xFFFF ? "\\X4\\%08X\\X0\\" : "\\X2\\%04X\\X0\\",
                    static_cast<unsigned>(c));
      result += code.data();
    }
  }
  return result + "'";
}

void writeStepText(const Model& model, std::ostream& out, const std::string& fileName,
                   const StepOptions& options, RunContext& run) {
  Writer(model, out, options, run).write(fileName);
}

}  // namespace swept::step
