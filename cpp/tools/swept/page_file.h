// --page: what a check found as a page for people (swept/page.h).
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

/// --page, --page-language, --page-template and --page-title.
void addPageOptions(CLI::App& app, PageJob& job);
/// Throws what a wrong usage is.
void checkPageOptions(const PageJob& job);
/// The template, if one is given, as an input of the command.
void addTemplate(const PageJob& job, std::vector<RoledFile>& inputs);

/// The row of an input file: its size and SHA-256. `role` as PageInput has it. To be called before
/// the file is read, so that a change in between is seen. Nothing is known of standard input.
PageInput inputRow(const std::string& role, const std::string& path);

/// What a page needs besides the result, read and checked before anything long starts. The date is
/// that of SOURCE_DATE_EPOCH (seconds since 1970) where the environment has it. Throws
/// Error(InvalidInput).
struct PageFrame {
  std::string layout, date;
};
PageFrame beginPage(const PageJob& job);

/// The text of the page. `report`: JSON. Throws Error(Cancelled).
std::string makePage(const PageJob& job, const PageFrame& frame, const std::string& report,
                     std::vector<PageInput> inputs, std::vector<PagePart> parts, RunContext& run);

}  // namespace swept::cli
