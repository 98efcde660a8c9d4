// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/regular_times.h"

#include "solid/assemble/zero_curves.h"

namespace swept::step {
namespace {

void appendHalved(Range s, int depth, const std::function<double(Range)>& quickestChange,
                  std::vector<Range>& to) {
  constexpr double kMaxLength = 10;  // times the time in which the curves change
  constexpr int kMaxDepth = 8;
  if (depth == kMaxDepth || s.length() <= kMaxLength * quickestChange(s)) {
    to.push_back(s);
    return;
  }
  appendHalved({s.from, s.at(0.5)}, depth + 1, quickestChange, to);
  appendHalved({s.at(0.5), s.to}, depth + 1, quickestChange, to);
}

}  // namespace

std::vector<Range> regularTimes(const std::function<bool(double)>& isRegular,
                                const std::function<double(Range)>& quickestChange, Range within) {
  std::vector<double> ends = zerosOf([&](double s) { return isRegular(s) ? 1.0 : -1.0; }, within);
  if (isRegular(within.from)) ends.insert(ends.begin(), within.from);
  if (isRegular(within.to)) ends.push_back(within.to);
  std::vector<Range> times;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    appendHalved({ends[i], ends[i + 1]}, 0, quickestChange, times);
  return times;
}

}  // namespace swept::step
