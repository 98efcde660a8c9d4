// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/mechanism_cases.h"

#include <algorithm>
#include <cmath>

#include "support/random_case.h"
#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

Trajectory someMotion(Random& random, const Vector3d& home) {
  Trajectory motion;
  const auto place = [&](double degrees, double reach) {
    const Vector3d axis = random.point(1);
    const double angle = random.number(0, degrees);
    const Vector3d shift = home + random.point(reach);
    return placement(axis, angle, shift);
  };
  if (random.number(0, 1) < 0.2) {
    motion.poses = {poseOf(0, place(360, 1))};
    return motion;
  }
  motion.interpolation = random.number(0, 1) < 0.5 ? Interpolation::Linear : Interpolation::Screw;
  if (random.number(0, 1) < 0.5) motion.pivot = random.point(3);
  const int poses = 2 + static_cast<int>(random.number(0, 6.99));
  double time = random.number(-1, 0);
  for (int i = 0; i < poses; ++i) {
    const bool waits = i > 0 && random.number(0, 1) < 0.2;
    Eigen::Isometry3d at = place(i == 0 ? 360 : 80, 3);
    if (i > 0) {
      const Pose& before = motion.poses.back();
      at.linear() = (before.rotation * Eigen::Quaterniond(at.linear())).toRotationMatrix();
    }
    Pose pose = poseOf(time, at);
    if (waits) {
      pose = motion.poses.back();
      pose.timeSeconds = time;
    }
    motion.poses.push_back(pose);
    time += i + 2 == poses ? std::max(0.1, random.number(5, 6) - time) : random.number(0.1, 0.8);
  }
  return motion;
}

std::string nameOf(const std::vector<MechanismPart>& parts, PartPair pair) {
  return parts[pair.first].name + " - " + parts[pair.second].name;
}

bool moves(const MechanismPart& part) { return part.motion.poses.size() > 1; }

/// Returns the part, standing still at a pose.
MechanismPart standing(const MechanismPart& part, const Pose& pose) {
  MechanismPart still = part;
  still.motion = {{pose}, Interpolation::Linear};
  return still;
}

std::string wrongPair(const std::vector<MechanismPart>& parts, const MechanismReport& report,
                      const PairClearance& pair, const StampedClearance& stamped) {
  const NeighbourClearance& row = pair.clearance;
  const std::string who = nameOf(parts, pair.parts) + ": ";
  if (stamped.distance < row.distance - report.tolerance - 1e-9)
    return who + "a stamp is nearer than promised";
  RunContext run;
  const double there =
      stampedPair(standing(parts[pair.parts.first], pair.poseOfFirst),
                  standing(parts[pair.parts.second], pair.poseOfSecond), {}, 0, run)
          .distance;
  if (!row.inside && std::abs(there - row.distance) > 1e-8)
    return who + "the distance is another one at the poses named";
  if (row.verdict != ClearanceVerdict::Clash && row.distance > 0 &&
      std::abs((row.pointOnBody - row.pointOnNeighbour).norm() - row.distance) > 1e-8)
    return who + "the points are not that far apart";
  if (row.verdict == ClearanceVerdict::Clear &&
      stamped.distance < report.required - report.tolerance)
    return who + "called clear and is nearer than required";
  if (stamped.distance <= 0 && row.verdict < ClearanceVerdict::Contact)
    return who + "the surfaces meet, and it is called apart";
  return "";
}

}  // namespace

std::vector<MechanismPart> randomMechanism(unsigned seed) {
  Random random(seed);
  std::mt19937 bodies(seed);
  std::vector<MechanismPart> parts;
  const int count = 3 + static_cast<int>(random.number(0, 3.99));
  for (int i = 0; i < count; ++i) {
    MechanismPart part{"part " + std::to_string(i), randomBody(bodies), {}, 0};
    part.motion = someMotion(random, random.point(7.5));
    parts.push_back(part);
  }
  // The first part moves. In some cases, the second one moves with it.
  while (!moves(parts[0])) parts[0].motion = someMotion(random, Vector3d::Zero());
  if (random.number(0, 1) < 0.3) parts[1].motion = parts[0].motion;
  return parts;
}

std::string wrongWith(const std::vector<MechanismPart>& parts, const MechanismReport& report,
                      int between) {
  if (report.status != Status::Ok) return report.code + ": " + report.message;
  RunContext run;
  auto row = report.pairs.begin();
  std::int64_t far = 0;
  for (PartPair pair; pair.first < std::ssize(parts); ++pair.first) {
    for (pair.second = pair.first + 1; pair.second < std::ssize(parts); ++pair.second) {
      const MechanismPart& a = parts[pair.first];
      const MechanismPart& b = parts[pair.second];
      const bool listed = row != report.pairs.end() && row->parts == pair;
      const auto& joined = report.joined;
      if (std::find(joined.begin(), joined.end(), pair) != joined.end() ||
          (!moves(a) && !moves(b))) {
        if (listed) return nameOf(parts, pair) + ": joined and listed";
        continue;
      }
      const StampedClearance stamped = stampedPair(a, b, report.time, between, run);
      if (listed) {
        const std::string wrong = wrongPair(parts, report, *row, stamped);
        if (!wrong.empty()) return wrong;
        ++row;
        continue;
      }
      ++far;
      if (stamped.distance < report.range)
        return nameOf(parts, pair) + ": missed, a stamp is " + std::to_string(stamped.distance) +
               " mm near";
    }
  }
  if (row != report.pairs.end()) return nameOf(parts, row->parts) + ": out of order";
  return far == report.farPairs ? "" : "far pairs are counted wrongly";
}

}  // namespace swept::test
