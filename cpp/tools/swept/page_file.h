// Implements --page: writes the result of a check as an HTML page (swept/page.h).
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
/// Throws an error for wrong usage.
void checkPageOptions(const PageJob& job);
/// Adds the template, if there is one, to the inputs of the command.
void addTemplate(const PageJob& job, std::vector<RoledFile>& inputs);

/// Returns the row of an input file in the page: its size and SHA-256. `role`: see PageInput. Call
/// this before the file is read. For streams, such as standard input, size and hash stay empty.
PageInput inputRow(const std::string& role, const std::string& path);

/// The parts of a page that are known before the computation: the template and the date.
struct PageFrame {
  std::string layout, date;
};
/// Reads and checks the template. Takes the date from the environment variable SOURCE_DATE_EPOCH
/// (seconds since 1970) if it is set. Throws Error(InvalidInput).
PageFrame beginPage(const PageJob& job);

/// Returns the text of the page. `report`: JSON. Throws Error(Cancelled).
std::string makePage(const PageJob& job, const PageFrame& frame, const std::string& report,
                     std::vector<PageInput> inputs, std::vector<PagePart> parts, RunContext& run);

}  // namespace swept::cli
