// What a page tells of a study: a table of its runs, the worst first, and a part for each run with
// its verdicts, graph and rules. The rows and their order are those of the report, where every run
// whose clearances were computed has their report as "clearance", and may have the address of its
// own page as "page" (docs/studies.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "page/rows.h"
#include "page/words.h"

namespace swept::page {

struct ToldRun {
  Json row;
  std::optional<Told> clearance;
};

struct ToldStudy {
  Json report;  ///< without what differs from run to run and from folder to folder
  std::vector<ToldRun> runs;
};

/// Throws Error(InvalidInput, "BadReport").
ToldStudy tellStudy(Json report);

/// How many runs are done, and the one to look at first.
std::string studyBanner(const ToldStudy& study, const Words& words);
std::string studyTable(const ToldStudy& study, const Words& words);
std::string studyRuns(const ToldStudy& study, const Words& words);

}  // namespace swept::page
