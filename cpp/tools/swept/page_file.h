// The option --page: writes the results of a check as an HTML page (swept/page.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "files.h"
#include "options.h"
#include "swept/page.h"

namespace swept::cli {

struct PageJob {
  std::string path;  ///< empty: no page
  std::string language = "en", title, templatePath;
};

/// Adds --page, --page-language, --page-template and --page-title.
void addPageOptions(CLI::App& app, PageJob& job);
/// Throws the error for wrong usage if the options do not fit together.
void checkPageOptions(const PageJob& job);
/// Adds the template to the inputs of the command, if one is given.
void addTemplate(const PageJob& job, std::vector<RoledFile>& inputs);

/// Returns the row of the page about an input file: its size and SHA-256. `role` as in PageInput.
/// Call this before the file is read, so that a change in between is noticed. For standard input,
/// size and SHA-256 are not known.
PageInput inputRow(const std::string& role, const std::string& path);

/// Everything that a page needs besides the result. Read and checked before a long computation
/// starts. The environment variable SOURCE_DATE_EPOCH (seconds since 1970), if set, gives the date.
/// Throws Error(InvalidInput).
struct PageFrame {
  std::string layout, date;
};
PageFrame beginPage(const PageJob& job);

/// Returns the text of the page. `report`: JSON. Throws Error(Cancelled).
std::string makePage(const PageJob& job, const PageFrame& frame, const std::string& report,
                     std::vector<PageInput> inputs, std::vector<PagePart> parts, RunContext& run);

}  // namespace swept::cli
