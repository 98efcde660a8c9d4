// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include "path_options.h"

#include <locale>
#include <numbers>
#include <sstream>
#include <vector>

namespace swept::cli {
namespace {

std::vector<double> numbersOf(const std::string& name, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ',');)
    numbers.push_back(numberOf(name, field));
  return numbers;
}

}  // namespace

Pose placementOf(const std::string& name, const std::string& text) {
  const std::vector<double> n = numbersOf(name, text);
  if (n.size() != 3 && n.size() != 7)
    badOption(name + " is '" + text +
              "'; a placement is x,y,z in mm or x,y,z,qx,qy,qz,qw with a unit quaternion");
  Pose pose;
  pose.translation = {n[0], n[1], n[2]};
  if (n.size() == 7) pose.rotation = Eigen::Quaterniond(n[6], n[3], n[4], n[5]);
  return pose;
}

Extraction extractionOf(const std::string& name, const std::string& text) {
  const std::vector<double> n = numbersOf(name, text);
  Extraction extraction;
  if (n.size() == 1)
    extraction.radius = n[0];
  else if (n.size() == 3)
    extraction.direction = Eigen::Vector3d(n[0], n[1], n[2]);
  else
    badOption(name + " is '" + text + "'; allowed: a radius in mm or a direction x,y,z");
  return extraction;
}

void addSearchOptions(CLI::App& app, PathOptions& o, std::int64_t& seed) {
  addNumber(app, "--clearance,--required", "MM", o.clearance,
            "distance to keep from every neighbour (default 0: more than the accuracy)");
  addNumber(app, "--tolerance,--accuracy", "MM", o.tolerance,
            "as for swept clearance (default 0.01)");
  addNumber(app, "--release", "MM", o.release,
            "contact is allowed until the part is so far out (default 0)");
  app.add_flag_callback(
      "--translation-only", [&o] { o.translationOnly = true; }, "the part never turns");
  addConverted(
      app, "--max-angle", "DEG",
      [&o](const std::string& t) {
        o.largestTurn = numberOf("--max-angle", t) * std::numbers::pi / 180;
      },
      "largest turn from how the part stands at the goal (default 180)");
  addNumber(app, "--budget", "S", o.budgetSeconds, "time after which a search ends (default 60)");
  addInteger(app, "--seed", seed, 0, std::int64_t{1} << 53,
             "another seed, perhaps another path (default 1)");
  addInteger(app, "--most-moves", o.mostSteps, 0, std::int64_t{1} << 53,
             "moves that a search in six dimensions tries at most, the same on every machine "
             "(default 0: no limit)");
  addConverted(
      app, "--interpolation", "linear|screw",
      [&o](const std::string& t) { o.interpolation = parseInterpolation(t); },
      "motion between two keys (default linear)");
}

std::string motionTable(const Trajectory& motion) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << "t,tx,ty,tz,qx,qy,qz,qw\n";
  for (const Pose& pose : motion.poses) {
    const Eigen::Vector3d& x = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    text << pose.timeSeconds << ',' << x[0] << ',' << x[1] << ',' << x[2] << ',' << q.x() << ','
         << q.y() << ',' << q.z() << ',' << q.w() << '\n';
  }
  return text.str();
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
