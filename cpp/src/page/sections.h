// The parts of a page that consist of text and tables.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "page/rows.h"
#include "page/words.h"
#include "swept/page.h"

namespace swept::page {

/// Returns a coloured sentence such as "All 12 checked pairs meet their rules." with the worst
/// distance.
std::string verdictBanner(const CheckReport& check, const Words& words);
std::string verdictTable(const CheckReport& check, const Words& words);
std::string rulesTable(const CheckReport& check, const Words& words);
/// Return only the tables of verdictTable() and rulesTable().
std::string verdictRows(const CheckReport& check, const Words& words);
std::string rulesRows(const CheckReport& check, const Words& words);
/// Returns the verdict in its colour. `allowed`: a rule allows this contact.
std::string verdictMark(const std::string& verdict, bool allowed, const Words& words);
std::string settingsTable(const CheckReport& check, const Words& words);
std::string inputsTable(const std::vector<PageInput>& inputs, const Words& words);
std::string findingsList(const CheckReport& check, const Words& words);
std::string findingsItems(const CheckReport& check,
                          const Words& words);  ///< empty if there are none
/// Throws Error(InvalidInput, "BadOption") for a media type that is not a picture.
std::string picturesOf(const std::vector<PagePicture>& pictures, const Words& words);

}  // namespace swept::page
