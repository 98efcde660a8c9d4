// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstdio>

#include "swept/clearance.h"

namespace swept {
namespace {

// Grows a JSON text; commas are put where they are needed.
class Json {
 public:
  Json& open(char bracket) {
    comma();
    text_ += bracket;
    fresh_ = true;
    return *this;
  }
  Json& close(char bracket) {
    text_ += bracket;
    fresh_ = false;
    return *this;
  }
  Json& key(const char* name) {
    string(name);
    text_ += ": ";
    fresh_ = true;
    return *this;
  }
  Json& string(const std::string& value) {
    comma();
    text_ += '"';
    for (const char c : value) escape(c);
    text_ += '"';
    return *this;
  }
  Json& number(double value) {
    comma();
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    text_ += std::isfinite(value) ? buffer : "null";
    return *this;
  }
  Json& integer(std::int64_t value) {
    comma();
    text_ += std::to_string(value);
    return *this;
  }
  Json& boolean(bool value) {
    comma();
    text_ += value ? "true" : "false";
    return *this;
  }
  Json& vector(const Eigen::Vector3d& v) {
    return open('[').number(v[0]).number(v[1]).number(v[2]).close(']');
  }
  std::string take() { return std::move(text_); }

 private:
  void comma() {
    if (!fresh_ && !text_.empty()) text_ += ", ";
    fresh_ = false;
  }
  void escape(char c) {
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char buffer[8];
      std::snprintf(buffer, sizeof buffer, "\\u%04x", static_cast<unsigned>(c));
      text_ += buffer;
    } else {
      text_ += c;
    }
  }
  std::string text_;
  bool fresh_ = true;
};

void put(Json& j, const Pose& pose) {
  j.open('{').key("t").number(pose.timeSeconds).key("translation").vector(pose.translation);
  const Eigen::Quaterniond& q = pose.rotation;
  j.key("quaternionXyzw").open('[').number(q.x()).number(q.y()).number(q.z()).number(q.w());
  j.close(']').close('}');
}

void put(Json& j, const char* key, const std::vector<TimeInterval>& intervals) {
  j.key(key).open('[');
  for (const TimeInterval& i : intervals) j.open('[').number(i.from).number(i.to).close(']');
  j.close(']');
}

void put(Json& j, const PenetrationResult& p) {
  j.open('{').key("depth").number(p.depth).key("depthBound").number(p.depthBound);
  j.key("timeSeconds").number(p.timeSeconds).key("pose");
  put(j, p.pose);
  j.key("pointOf").string(p.pointOfBody ? "body" : "neighbour");
  j.key("point").vector(p.point).key("surface").vector(p.surface);
  j.key("regionMin").vector(p.regionMin).key("regionMax").vector(p.regionMax).close('}');
}

void put(Json& j, const NeighbourClearance& row) {
  j.open('{').key("name").string(row.name);
  j.key("verdict").string(clearanceVerdictName(row.verdict));
  j.key("distance").number(row.distance).key("guaranteed").number(row.guaranteed);
  j.key("chordError").number(row.chordError).key("timeSeconds").number(row.timeSeconds).key("pose");
  put(j, row.pose);
  j.key("pointOnBody").vector(row.pointOnBody).key("pointOnNeighbour").vector(row.pointOnNeighbour);
  j.key("bodyTriangle").integer(row.bodyTriangle);
  j.key("neighbourTriangle").integer(row.neighbourTriangle);
  j.key("closed").boolean(row.closed).key("inside").boolean(row.inside);
  if (row.penetration.known) {
    j.key("penetration");
    put(j, row.penetration);
  }
  put(j, "below", row.below);
  put(j, "contact", row.contact);
  j.key("curve").open('[');
  for (const CurvePoint& p : row.curve)
    j.open('[').number(p.timeSeconds).number(p.distance).close(']');
  j.close(']').key("distanceQueries").integer(row.distanceQueries);
  j.key("certificates").integer(row.certificates).key("seconds").number(row.seconds).close('}');
}

}  // namespace

std::string toJson(const ClearanceReport& r) {
  Json j;
  j.open('{').key("status").string(statusName(r.status));
  j.key("code").string(r.code).key("message").string(r.message).key("summary").string(r.summary);
  j.key("required").number(r.required).key("tolerance").number(r.tolerance);
  j.key("interpolation").string(r.interpolation).key("witness").string(r.witness);
  j.key("placements").integer(r.placements).key("bodyTriangles").integer(r.bodyTriangles);
  j.key("neighbourTriangles").integer(r.neighbourTriangles).key("threads").integer(r.threads);
  j.key("smallest").integer(r.smallest).key("neighbours").open('[');
  for (const NeighbourClearance& row : r.neighbours) put(j, row);
  j.close(']').key("seconds").open('{');
  for (const StageSeconds& s : r.seconds) j.key(s.stage.c_str()).number(s.seconds);
  j.close('}').key("warnings").open('[');
  for (const Finding& f : r.warnings) {
    j.open('{').key("code").string(f.code).key("count").integer(f.count).key("first").open('[');
    for (const std::int64_t i : f.first) j.integer(i);
    j.close(']').key("text").string(f.text).close('}');
  }
  j.close(']').close('}');
  return j.take();
}

}  // namespace swept
