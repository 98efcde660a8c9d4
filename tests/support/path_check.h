// Checks a path against the promises of the search, from its key poses alone.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "support/path_cases.h"
#include "swept/path.h"

namespace swept::test {

inline PathTask taskOf(const PathCase& c) {
  PathTask task;
  task.goal = c.goal;
  task.start = c.start;
  return task;
}

inline std::vector<ClearanceNeighbour> neighboursOf(const PathCase& c) {
  std::vector<ClearanceNeighbour> list;
  for (const TriMesh& mesh : c.neighbours)
    list.push_back({"part " + std::to_string(list.size() + 1), mesh});
  return list;
}

inline PathOptions optionsOf(const PathCase& c) {
  PathOptions options;
  options.clearance = c.clearance;
  options.release = c.release;
  return options;
}

/// Returns options with enough time for sanitizers too: a search that ends at its time limit tests
/// nothing.
inline PathOptions patient(const PathCase& c) {
  PathOptions options = optionsOf(c);
  options.budgetSeconds = 1000;
  return options;
}

/// Returns an empty text if the report is right, otherwise what is wrong.
inline std::string wrongWith(const PathCase& c, const PathReport& report) {
  if (report.status != Status::Ok) {
    const bool blocked = report.code == "StartBlocked" || report.code == "GoalBlocked";
    // Scattered boxes may overlap the start.
    if (blocked && c.name == "scattered") return {};
    return std::string(statusName(report.status)) + "/" + report.code + ": " + report.message;
  }
  if (report.verdict != PathVerdict::Found) {
    if (!report.path.poses.empty()) return "keys without a path";
    return c.possible ? "a path exists, none was found" : "";
  }
  if (!c.possible) return "a path where there is none";
  if (c.needsTurn && report.turn < 0.5) return "no turn where one is needed";
  const std::vector<Pose>& poses = report.path.poses;
  const auto same = [](const Pose& a, const Pose& b) {
    return (a.translation - b.translation).norm() < 1e-9 &&
           a.rotation.angularDistance(b.rotation) < 1e-9;
  };
  if (poses.size() < 2 || !same(poses.front(), c.start) || !same(poses.back(), c.goal))
    return "the path does not lead from start to goal";
  // Inside the release zone, contact is allowed. The first key outside the zone must be clear.
  Trajectory free = report.path;
  if (c.release > 0) free.poses.pop_back();
  const std::vector<ClearanceNeighbour> parts = neighboursOf(c);
  ClearanceOptions options;
  options.required = c.clearance;
  options.curveSamples = 0;
  RunContext run;
  const auto check = [&](const Trajectory& motion) {
    return checkClearance(c.part, motion, parts, options, run);
  };
  for (const NeighbourClearance& row : check(free).neighbours)
    if (row.verdict != ClearanceVerdict::Clear)
      return "not clear of " + row.name + ": " + clearanceVerdictName(row.verdict);
  if (c.release > 0) {
    options.required = 0;
    for (const NeighbourClearance& row : check(report.path).neighbours)
      if (row.verdict == ClearanceVerdict::Clash) return "a clash with " + row.name;
  }
  return {};
}

}  // namespace swept::test
