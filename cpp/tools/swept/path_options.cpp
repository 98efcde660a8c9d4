// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include "path_options.h"

#include <locale>
#include <numbers>
#include <sstream>
#include <vector>

namespace swept::cli {

Pose placementOf(const std::string& name, const std::string& text) {
  const std::vector<double> n = numbersOf(name, text);
  if (n.size() != 3 && n.size() != 7)
    badOption(name + " is '" + text +
              "'; expected a placement: x,y,z in mm, or x,y,z,qx,qy,qz,qw with a unit quaternion");
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
    badOption(name + " is '" + text + "'; allowed: a distance in mm or a direction x,y,z");
  return extraction;
}

void addSearchOptions(CLI::App& app, PathOptions& o, std::int64_t& seed) {
  addNumber(app, "--clearance,--required", "MM", o.clearance,
            "distance to keep from every neighbour (default 0: the parts must not touch, so they "
            "stay apart by more than --accuracy)");
  addNumber(app, "--tolerance,--accuracy", "MM", o.tolerance,
            "largest error of a smallest distance (default 0.01)");
  addNumber(app, "--release", "MM", o.release,
            "near the start and the goal: if the part is closer to a neighbour there than "
            "required, it may stay that close, or touch, until some point of the part has moved "
            "farther than this (default 0)");
  app.add_flag_callback(
      "--translation-only", [&o] { o.translationOnly = true; },
      "search only for paths on which the part never turns");
  addConverted(
      app, "--max-angle", "DEG",
      [&o](const std::string& t) {
        o.largestTurn = numberOf("--max-angle", t) * std::numbers::pi / 180;
      },
      "largest angle in degrees by which the part may turn away from its orientation at the goal "
      "(default 180: no limit)");
  addNumber(app, "--budget", "S", o.budgetSeconds,
            "time limit in seconds, after which the search ends without a path (default 60)");
  addInteger(app, "--seed", seed, 0, std::int64_t{1} << 53,
             "seed of the random numbers; another seed may find another path (default 1)");
  addInteger(
      app, "--most-moves", o.mostSteps, 0, std::int64_t{1} << 53,
      "largest number of moves that a search with turns tries before it ends without a path. "
      "Unlike the time limit, it gives the same result on every machine (default 0: no limit)");
  addConverted(
      app, "--interpolation", "linear|screw",
      [&o](const std::string& t) { o.interpolation = parseInterpolation(t); },
      "how the part moves between two keys (default linear)");
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
