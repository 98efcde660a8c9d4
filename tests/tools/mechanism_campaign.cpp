// Checks many random mechanisms. Compares each report with distances of FCL at sampled poses
// ("stamps").
// Usage: swept_mechanism_campaign FIRST LAST [BETWEEN [THREADS]]; ends with 1 if anything is wrong.
// BETWEEN: number of stamps between two poses (default 40).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "support/mechanism_cases.h"

int main(int argc, char** argv) {
  using namespace swept;
  const auto argument = [&](int i, int otherwise) {
    return argc > i ? std::atoi(argv[i]) : otherwise;
  };
  const int first = argument(1, 0), last = argument(2, 99);
  int wrong = 0;
  long long pairs = 0, far = 0, joined = 0, clashes = 0, contacts = 0, below = 0;
  double seconds = 0, worst = 0;
  for (int seed = first; seed <= last; ++seed) {
    const auto parts = test::randomMechanism(static_cast<unsigned>(seed));
    MechanismOptions options;
    options.required = 0.3;
    RunContext run;
    run.threads = argument(4, 1);
    const std::clock_t start = std::clock();
    const MechanismReport report = checkMechanism(parts, options, run);
    const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    seconds += taken;
    worst = std::max(worst, taken);
    const std::string what = test::wrongWith(parts, report, argument(3, 40));
    if (!what.empty()) {
      ++wrong;
      std::printf("%d: WRONG: %s\n", seed, what.c_str());
      std::fflush(stdout);
    }
    pairs += std::ssize(report.pairs);
    far += report.farPairs;
    joined += std::ssize(report.joined);
    for (const PairClearance& pair : report.pairs) {
      clashes += pair.clearance.verdict == ClearanceVerdict::Clash;
      contacts += pair.clearance.verdict == ClearanceVerdict::Contact;
      below += pair.clearance.verdict == ClearanceVerdict::BelowRequired;
    }
  }
  std::printf(
      "%d mechanisms, %d wrong; pairs: %lld near (%lld clash, %lld contact, %lld below), "
      "%lld far, %lld joined; %.3f CPU s each, worst %.2f\n",
      last - first + 1, wrong, pairs, clashes, contacts, below, far, joined,
      seconds / (last - first + 1), worst);
  return wrong > 0 ? 1 : 0;
}
