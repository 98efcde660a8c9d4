// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/limits.h"
#include "base/number_text.h"
#include "geometry/mesh_numbers.h"
#include "motion/pivot.h"
#include "motion/step_path.h"
#include "page/html.h"
#include "page/resources.h"
#include "swept/drawable.h"

namespace swept::page {
namespace {

constexpr int kMoments = 120;  // intervals between evenly spaced frames
// Largest number of frames for a motion without interpolation.
constexpr std::size_t kMaxCopies = 400;
constexpr double kCrease = 0.5;  // rad, as in the workbench's 3D view in FreeCAD
// Positions are rounded to this many steps along each side of the box.
constexpr double kSteps = 65535;

template <class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
  return base64(numbers.data(), numbers.size() * sizeof(Number));
}

struct Frame {
  double time = 0;
  const Row* row = nullptr;  // the row whose moment this is, if any
};

/// Returns for each part how many triangles it may have. Triangles that small parts do not need are
/// left for the larger ones.
std::vector<std::size_t> triangleLimits(const std::vector<PagePart>& parts, std::size_t all) {
  std::vector<std::size_t> order(parts.size()), limits(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) order[i] = i;
  const auto size = [&](std::size_t i) { return parts[i].mesh.triangles.size(); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::size_t left = all;
  for (std::size_t k = 0; k < order.size(); ++k) {
    limits[order[k]] =
        std::max<std::size_t>(1, std::min(size(order[k]), left / (order.size() - k)));
    left -= std::min(left, limits[order[k]]);
  }
  return limits;
}

/// Throws Error(InvalidInput) if the part cannot be drawn.
void checkPart(const PagePart& part) {
  const auto refuse = [&](const char* code, const std::string& text) {
    throw Error(Status::InvalidInput, code, "part '" + part.name + "' of the 3D view: " + text);
  };
  if (const auto bad = findBadIndex(part.mesh))
    refuse("BadIndex", badIndexText(*bad, part.mesh) + "; export the part again");
  const Coordinates found = measureCoordinates(part.mesh);
  if (found.nonFinite > 0)
    refuse("NonFiniteVertex", counted(found.nonFinite, "vertex has", "vertices have") +
                                  " a coordinate that is not a finite number (first: vertex " +
                                  std::to_string(found.firstNonFinite[0]) +
                                  ", counted from 0); export the part again");
  if (found.largest > kMaxLength)
    refuse(
        "OutOfRange",
        "vertex " + std::to_string(found.farthest) + " (counted from 0) lies " +
            numberText(found.largest) +
            " mm from the origin, but the limit is 1e9 mm; check the unit of length of the part");
  for (std::size_t i = 0; i < part.motion.poses.size(); ++i) {
    const Pose& pose = part.motion.poses[i];
    if (!std::isfinite(pose.timeSeconds) || !pose.translation.allFinite() ||
        !pose.rotation.coeffs().allFinite() || !(pose.rotation.norm() > 0))
      refuse("BadPose",
             "pose " + std::to_string(i + 1) +
                 " (counted from 1) has a number that is not finite, or a quaternion of length 0; "
                 "correct or remove this pose");
  }
}

void addShape(const Drawable& shape, Json& json) {
  const float infinity = std::numeric_limits<float>::infinity();
  Eigen::Vector3f low = Eigen::Vector3f::Constant(infinity), high = -low;
  for (const Eigen::Vector3f& p : shape.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (shape.points.empty()) low = high = Eigen::Vector3f::Zero();
  const double size = double((high - low).maxCoeff());
  const double step = size > 0 ? size / kSteps : 1.0;
  std::vector<std::uint16_t> points;
  std::vector<std::int8_t> normals;
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      points.push_back(
          static_cast<std::uint16_t>(std::lround(double(shape.points[i][k] - low[k]) / step)));
      const double normal = std::clamp(double(shape.normals[i][k]), -1.0, 1.0);
      normals.push_back(static_cast<std::int8_t>(std::lround(127 * normal)));
    }
  std::vector<std::uint32_t> indices;
  for (const std::int32_t i : shape.indices)
    if (i >= 0) indices.push_back(static_cast<std::uint32_t>(i));
  json["origin"] = {low[0], low[1], low[2]};
  json["step"] = step;
  json["points"] = bytesOf(points);
  json["normals"] = bytesOf(normals);
  const bool wide = shape.points.size() > 0x10000;
  json["wide"] = wide;
  json["indices"] =
      wide ? bytesOf(indices) : bytesOf(std::vector<std::uint16_t>(indices.begin(), indices.end()));
}

std::vector<Frame> framesOf(const CheckReport& check, const std::vector<PagePart>& parts) {
  std::vector<Frame> frames;
  for (const Row& row : check.rows) frames.push_back({row.time, &row});
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (const PagePart& part : parts) {
    const std::vector<Pose>& poses = part.motion.poses;
    if (poses.size() < 2) continue;
    from = std::min(from, poses.front().timeSeconds);
    to = std::max(to, poses.back().timeSeconds);
    if (part.motion.interpolation != Interpolation::None) continue;
    const std::size_t copies = std::min(poses.size(), kMaxCopies);
    for (std::size_t i = 0; i < copies; ++i)
      frames.push_back(
          {poses[i * (poses.size() - 1) / std::max<std::size_t>(1, copies - 1)].timeSeconds,
           nullptr});
  }
  if (check.report.contains("from_seconds") && check.report.contains("to_seconds")) {
    from = check.report["from_seconds"].get<double>();
    to = check.report["to_seconds"].get<double>();
  }
  const bool copies = std::any_of(parts.begin(), parts.end(), [](const PagePart& part) {
    return part.motion.poses.size() > 1 && part.motion.interpolation == Interpolation::None;
  });
  if (!copies && to > from)
    for (int i = 0; i <= kMoments; ++i)
      frames.push_back({from + (to - from) * i / kMoments, nullptr});
  std::stable_sort(frames.begin(), frames.end(),
                   [](const Frame& a, const Frame& b) { return a.time < b.time; });
  return frames;
}

std::vector<float> posesOf(const PagePart& part, const std::vector<Frame>& frames, bool mechanism) {
  std::vector<float> numbers;
  for (const Frame& frame : frames) {
    const bool isGiven = frame.row && !mechanism;  // the report gives the pose
    const Pose pose = isGiven                     ? frame.row->pose
                      : part.motion.poses.empty() ? Pose{}
                                                  : poseAt(part.motion, frame.time);
    for (int k = 0; k < 3; ++k) numbers.push_back(float(pose.translation[k]));
    // in the order x, y, z, w
    for (int k = 0; k < 4; ++k) numbers.push_back(float(pose.rotation.coeffs()[k]));
  }
  return numbers;
}

Json rowsJson(const CheckReport& check, const std::vector<Frame>& frames,
              const std::vector<PagePart>& parts) {
  Json list = Json::array();
  for (const std::size_t index : check.order) {
    const Row& row = check.rows[index];
    const auto frame =
        std::find_if(frames.begin(), frames.end(), [&](const Frame& f) { return f.row == &row; });
    Json touched = Json::array();
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].name == row.second ||
          (check.mechanism ? parts[i].name == row.first : parts[i].moves))
        touched.push_back(i);
    Json line = Json::array();
    for (const Eigen::Vector3d& x : row.line) line.push_back({x[0], x[1], x[2]});
    list.push_back(
        {{"row", index},
         {"name", row.name},
         {"verdict", row.meetsRule && row.verdict == "contact" ? "allowed" : row.verdict},
         {"frame", frame - frames.begin()},
         {"line", line},
         {"parts", touched}});
  }
  return list;
}

/// Returns the worst verdict of a part; none for the moving body of a clearance report.
std::string verdictOf(const PagePart& part, const CheckReport& check) {
  if (part.moves && !check.mechanism) return "none";
  for (const std::size_t index : check.order) {
    const Row& row = check.rows[index];
    if (row.second == part.name || (check.mechanism && row.first == part.name))
      return row.meetsRule && row.verdict == "contact" ? "allowed" : row.verdict;
  }
  return "none";
}

std::string controls(const CheckReport& check, const Words& words) {
  std::string out = "<div class=\"controls\">\n<button type=\"button\" id=\"view-play\">" +
                    escaped(words("view_play")) +
                    "</button>\n<input type=\"range\" id=\"view-time\" "
                    "min=\"0\" value=\"0\" aria-label=\"" +
                    escaped(words("view_time")) + "\" />\n<output id=\"view-now\"></output>\n";
  out += "<label>" + escaped(words("view_worst")) + " <select id=\"view-row\">";
  for (const std::size_t index : check.order)
    out += "<option value=\"" + std::to_string(index) + "\">" + escaped(check.rows[index].name) +
           "</option>";
  return out + "</select></label>\n<button type=\"button\" id=\"view-reset\">" +
         escaped(words("view_reset")) + "</button>\n</div>\n";
}

}  // namespace

Pose poseAt(const Trajectory& motion, double time) {
  const std::vector<Pose>& poses = motion.poses;
  const auto after = std::upper_bound(poses.begin(), poses.end(), time,
                                      [](double t, const Pose& p) { return t < p.timeSeconds; });
  if (after == poses.begin()) return poses.front();
  const std::size_t i = static_cast<std::size_t>(after - poses.begin()) - 1;
  if (after == poses.end() || motion.interpolation == Interpolation::None) return poses[i];
  const Eigen::Vector3d pivot = pivotOf(motion);
  Trajectory step{{poses[i], poses[i + 1]}, motion.interpolation, motion.pivot};
  step = carriedByPivot(std::move(step), pivot);
  const double span = poses[i + 1].timeSeconds - poses[i].timeSeconds;
  const StepPath path(step.poses[0], step.poses[1], motion.interpolation);
  return backFromPivot(path.poseAt((time - poses[i].timeSeconds) / span), pivot);
}

std::string viewOf(const CheckReport& check, const PageOptions& options, const Words& words,
                   RunContext& run) {
  if (options.parts.empty()) return {};
  const std::string script = resourceText("view");
  if (script.empty())
    return section("view", words("view"), element("p", escaped(words("view_not_built")), "note"));
  const std::vector<Frame> frames = framesOf(check, options.parts);
  const std::vector<std::size_t> limits = triangleLimits(options.parts, options.viewTriangles);
  Json parts = Json::array();
  std::size_t shown = 0, all = 0;
  for (std::size_t i = 0; i < options.parts.size(); ++i) {
    run.checkpoint(Phase::Export, i, options.parts.size());
    const PagePart& part = options.parts[i];
    checkPart(part);
    const Drawable shape = drawableOf(part.mesh, limits[i], kCrease);
    shown += shape.indices.size() / 4;
    all += part.mesh.triangles.size();
    Json json{{"name", part.name},
              {"kind", part.translucent ? "envelope"
                       : part.moves     ? "moves"
                                        : "stands"},
              {"verdict", verdictOf(part, check)}};
    addShape(shape, json);
    if (part.moves) json["poses"] = bytesOf(posesOf(part, frames, check.mechanism));
    parts.push_back(std::move(json));
  }
  Json times = Json::array();
  for (const Frame& frame : frames) times.push_back(frame.time);
  const Json scene{{"parts", std::move(parts)},
                   {"times", times},
                   {"rows", rowsJson(check, frames, options.parts)},
                   {"words", {{"play", words("view_play")}, {"pause", words("view_pause")}}},
                   {"language", words.language()}};
  const std::string how = shown < all
                              ? words("view_simplified", std::to_string(shown), std::to_string(all))
                              : words("view_full", std::to_string(all));
  return section("view", words("view"),
                 "<div class=\"stage\"><canvas id=\"view-canvas\"></canvas><fieldset "
                 "id=\"view-parts\"><legend>" +
                     escaped(words("view_parts")) + "</legend></fieldset></div>\n" +
                     controls(check, words) + "<p class=\"note\" id=\"view-needs\">" +
                     escaped(words("view_needs")) + "</p>\n" + element("p", escaped(how), "note") +
                     "\n" + dataElement("scene", scene) + "<script>\n" + script + "</script>\n");
}

}  // namespace swept::page
