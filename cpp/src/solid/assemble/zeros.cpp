// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/zeros.h"

#include <algorithm>

namespace swept::step {

std::vector<double> zerosOf(const OfTime& f, Range range) {
  constexpr int kHalvings = 60;
  std::vector<double> zeros;
  double a = range.from, fa = f(a);
  for (int i = 1; i <= kZeroSteps; ++i) {
    const double b = range.at(static_cast<double>(i) / kZeroSteps), fb = f(b);
    if ((fa < 0) != (fb < 0)) {
      double low = a, high = b;
      for (int round = 0; round < kHalvings; ++round) {
        const double middle = (low + high) / 2;
        ((f(middle) < 0) == (fa < 0) ? low : high) = middle;
      }
      zeros.push_back((low + high) / 2);
    }
    a = b;
    fa = fb;
  }
  return zeros;
}

std::vector<Range> timesWithin(const OfTime& f, double low, double high, Range range) {
  std::vector<double> ends{range.from, range.to};
  for (const double bound : {low, high}) {
    for (const double s : zerosOf([&](double at) { return f(at) - bound; }, range))
      ends.push_back(s);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Range> within;
  constexpr double kNoTime = 1e-9;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Range part{ends[i], ends[i + 1]};
    const double middle = f(part.at(0.5));
    if (part.length() > kNoTime && middle >= low && middle <= high) within.push_back(part);
  }
  return within;
}

}  // namespace swept::step
