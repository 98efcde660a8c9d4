// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/pair_check.h"

#include "base/number_text.h"
#include "base/timer.h"
#include "clearance/penetration.h"
#include "input/body_check.h"

namespace swept::clearance {
namespace {

class PairCheck {
 public:
  PairCheck(const CheckedPair& parts, const MotionTree& motion, const ClearanceOptions& options,
            RunContext& run)
      : parts_(parts), motion_(motion), o_(options), run_(run) {}

  NeighbourClearance operator()(const CheckedNeighbour& neighbour) const {
    const Timer timer;
    const PairSearch pair(parts_.body, parts_.neighbour);
    SearchContext context{pair, motion_, run_, parts_.within};
    NeighbourClearance row;
    row.name = neighbour.name;
    row.rule = neighbour.rule;
    row.chordError = o_.bodyChordError + neighbour.chordError;
    row.closed = parts_.neighbour.closed();
    const double touch = o_.tolerance + row.chordError;
    const double slack = motion_.isContinuous() ? o_.tolerance : 0.0;
    Minimum least = searchMinimum(context, slack);
    if (!least.found()) least.distance = std::numeric_limits<double>::infinity();
    row.inside = least.inside;
    if (least.inside || least.distance <= slack) {
      // If contact is allowed, parts overlap slightly in many places. So the search gets more
      // effort.
      const std::int64_t effort = row.rule.contact ? 200000 : o_.penetration ? 40000 : 4000;
      row.penetration = deepestPenetration(context, least, o_.tolerance, effort);
      const bool undecidable = !row.penetration.known && least.distance <= 0 &&
                               !parts_.body.closed() && !parts_.neighbour.closed();
      if (row.penetration.depth > std::max(touch, row.rule.contact.value_or(0)) || undecidable)
        row.verdict = ClearanceVerdict::Clash;
      else
        row.verdict = ClearanceVerdict::Contact;
    } else if (least.distance <= touch) {
      row.verdict = ClearanceVerdict::Contact;
    }
    fillMinimum(row, least, pair);
    // The caller does not know the triangles of a repaired copy.
    if (parts_.neighbourMended) row.neighbourTriangle.reset();
    if (parts_.bodyMended) row.bodyTriangle.reset();
    row.guaranteed = std::max(0.0, row.distance - slack - row.chordError);
    const double required = row.rule.required.value_or(0);
    const bool below = required > 0 && row.distance - row.chordError < required;
    if (row.verdict == ClearanceVerdict::Clear && below)
      row.verdict = ClearanceVerdict::BelowRequired;
    fillSpans(row, context, touch, below);
    for (const auto& [u, d] : sampleDistances(context, least.found() ? o_.curveSamples : 0,
                                              parameterOfMinimum(row, least)))
      row.curve.push_back({motion_.timeAt(u), d});
    row.distanceQueries = context.queries;
    row.certificates = context.certificates;
    row.seconds = timer.seconds();
    return row;
  }

 private:
  double parameterOfMinimum(const NeighbourClearance& row, const Minimum& least) const {
    return row.verdict == ClearanceVerdict::Clash && row.penetration.known
               ? row.penetration.parameter
               : least.parameter;
  }

  void fillMinimum(NeighbourClearance& row, const Minimum& least, const PairSearch& pair) const {
    const bool clash = row.verdict == ClearanceVerdict::Clash && row.penetration.known;
    row.distance = clash ? 0.0 : least.distance;
    row.pose = motion_.poseAt(parameterOfMinimum(row, least));
    row.timeSeconds = row.pose.timeSeconds;
    if (clash) {
      row.pointOnBody =
          row.penetration.pointOfBody ? row.penetration.point : row.penetration.surface;
      row.pointOnNeighbour =
          row.penetration.pointOfBody ? row.penetration.surface : row.penetration.point;
      return;
    }
    if (least.at.pair.body < 0) return;
    row.pointOnBody = least.at.onBody;
    row.pointOnNeighbour = least.at.onNeighbour;
    row.bodyTriangle = pair.body().triangle(least.at.pair.body);
    row.neighbourTriangle = pair.neighbour().triangle(least.at.pair.neighbour);
  }

  void fillSpans(NeighbourClearance& row, SearchContext& context, double touch, bool below) const {
    const double resolution =
        motion_.isContinuous() ? o_.intervalTolerance.value_or(10 * o_.tolerance) : 0.0;
    // No overlap is deeper than the bound of the whole motion.
    const double deepest = row.penetration.depthBound;
    const OverlapTest overlaps = [&](const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double d) {
      return d <= deepest && overlapsAtLeast(context.pair, R, t, d);
    };
    const auto timesBelow = [&](double level) {
      std::vector<TimeInterval> times;
      for (const auto& [from, to] : spansBelow(context, level, resolution, overlaps))
        times.push_back({motion_.timeAt(from), motion_.timeAt(to)});
      return times;
    };
    if (below) row.below = timesBelow(*row.rule.required + row.chordError);
    if (row.verdict >= ClearanceVerdict::Contact) row.contact = timesBelow(touch);
  }

  const CheckedPair& parts_;
  const MotionTree& motion_;
  const ClearanceOptions& o_;
  RunContext& run_;
};

/// Largest number of neighbours that one warning names.
constexpr std::size_t kMaxNamedOpen = 8;

}  // namespace

Part closedPart(const TriMesh& mesh, const std::string& who, RunContext& run, bool& mended) {
  Part part(mesh, who);
  if (part.closed()) return part;
  try {
    const CheckedBody checked = checkBody(mesh, Options{}, run);
    if (!checked.orientable) return part;
    mended = true;
    return Part(checked.mesh, who);
  } catch (const Error& error) {
    if (error.status() == Status::InvalidInput)
      return part;  // for example a flat sheet, which is still a valid neighbour
    throw;
  }
}

NeighbourRule ruleFor(const NeighbourRule& own, double commonRequired) {
  if (own.contact) return {{}, own.contact};
  return {own.required.value_or(commonRequired)};
}

NeighbourClearance checkPair(const CheckedPair& parts, const CheckedNeighbour& neighbour,
                             const MotionTree& motion, const ClearanceOptions& options,
                             RunContext& run) {
  return PairCheck(parts, motion, options, run)(neighbour);
}

std::vector<Finding> openFindings(const std::vector<std::string>& names,
                                  const std::vector<char>& closed, bool bodyClosed,
                                  const std::string& one, const std::string& many) {
  std::vector<Finding> findings;
  Finding open{"OpenMesh", 0, {}, ""};
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (closed[i] != 0) continue;
    ++open.count;
    if (open.first.size() >= kMaxNamedOpen) continue;
    open.first.push_back(static_cast<std::int64_t>(i));
    list += (list.empty() ? "" : ", ") + (names[i].empty() ? std::to_string(i + 1) : names[i]);
  }
  if (open.count > 0) {
    if (static_cast<std::size_t>(open.count) > open.first.size()) list += ", ...";
    open.text = counted(open.count, one + " is open or has", many + " are open or have") +
                " wrongly oriented triangles (" + list +
                "): a part that lies completely inside such a surface is not noticed, and the "
                "depth of an overlap is measured only on the other part; repair the mesh";
    findings.push_back(open);
  }
  if (!bodyClosed)
    findings.push_back({"OpenBody",
                        1,
                        {},
                        "the moving part is open or has wrongly oriented triangles: a neighbour "
                        "that lies completely inside the part is not noticed; repair the mesh"});
  return findings;
}

}  // namespace swept::clearance
