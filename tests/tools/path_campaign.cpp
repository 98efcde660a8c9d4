// Solves many random path problems. Checks each path again from its keys with checkClearance(), and
// each verdict against what is known of the problem.
// Usage: swept_path_campaign FIRST LAST [BUDGET_S [THREADS [KIND [MOVES]]]]
// KIND: name of the only cases to solve, or "hard" for the kinds of hardPathCase(). MOVES: limit of
// moves instead of a time limit; 0: none. Ends with 1 if anything fails.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "support/path_cases.h"
#include "support/path_check.h"

int main(int argc, char** argv) {
  using namespace swept;
  const auto argument = [&](int i, double otherwise) {
    return argc > i ? std::atof(argv[i]) : otherwise;
  };
  const auto first = static_cast<unsigned>(argument(1, 0));
  const auto last = static_cast<unsigned>(argument(2, 89));
  const std::string kind = argc > 5 ? argv[5] : "";
  struct Tally {
    int count = 0, found = 0, failed = 0;
    double seconds = 0, worst = 0;
  };
  std::map<std::string, Tally> tallies;
  int failures = 0;
  for (unsigned number = first; number <= last; ++number) {
    const bool hard = kind == "hard";
    const test::PathCase c = hard ? test::hardPathCase(number) : test::pathCase(number);
    if (!kind.empty() && !hard && c.name != kind) continue;
    RunContext run;
    run.threads = static_cast<int>(argument(4, 1));
    PathOptions options = test::optionsOf(c);
    options.budgetSeconds = argument(3, 10);
    if (argument(6, 0) > 0) options.mostSteps = static_cast<std::int64_t>(argument(6, 0));
    options.tryLowerClearance = !options.mostSteps;
    const std::clock_t start = std::clock();
    const PathReport report =
        findPath(c.part, test::taskOf(c), test::neighboursOf(c), options, run);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::string wrong = test::wrongWith(c, report);
    Tally& tally = tallies[c.name];
    ++tally.count;
    tally.found += report.verdict == PathVerdict::Found;
    tally.seconds += seconds;
    tally.worst = std::max(tally.worst, seconds);
    if (!wrong.empty()) {
      ++failures;
      ++tally.failed;
    }
    if (argc > 7 || !wrong.empty())
      std::printf("%u %s: %.2f CPU s, %lld steps, %s%s%s %s\n", number, c.name.c_str(), seconds,
                  static_cast<long long>(report.steps), pathVerdictName(report.verdict),
                  wrong.empty() ? "" : "; WRONG: ", wrong.c_str(), report.summary.c_str());
    std::fflush(stdout);
  }
  for (const auto& [name, t] : tallies)
    std::printf("%-10s %5d problems, %5d found, %d wrong, mean %.3f CPU s, worst %.2f\n",
                name.c_str(), t.count, t.found, t.failed, t.seconds / t.count, t.worst);
  return failures > 0 ? 1 : 0;
}
