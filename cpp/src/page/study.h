// The page of a study: a table of its runs, the worst first, and a section for each run with its
// verdicts, graph and rules. The rows and their order come from the report of the study. If the
// clearances of a run are computed, the row of the run contains their report as "clearance". A run
// may have the address of its own page as "page" (docs/studies.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "page/rows.h"
#include "page/words.h"

namespace swept::page {

struct StudyRun {
  Json row;
  std::optional<CheckReport> clearance;
};

struct StudyReport {
  Json report;  ///< without data that differ from run to run or folder to folder
  std::vector<StudyRun> runs;
};

/// Reads the report of a study. Throws Error(InvalidInput, "BadReport").
StudyReport readStudy(Json report);

/// Returns a sentence with the number of runs that are done, and a link to the run to examine
/// first.
std::string studyBanner(const StudyReport& study, const Words& words);
std::string studyTable(const StudyReport& study, const Words& words);
std::string studyRuns(const StudyReport& study, const Words& words);

}  // namespace swept::page
