// Draws the graph of distances over time as an svg element.
// The scale of distances is linear near 0 and logarithmic beyond (asinh), so that the required
// distance stays visible however large the largest distance is. A curve shows its name if the
// reader points at it. Colours are attributes, for readers without style sheets; the page's style
// sheet changes some.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "page/rows.h"
#include "page/words.h"

namespace swept::page {

/// Returns the section; empty if the report has no curves.
std::string graphOf(const CheckReport& check, const Words& words);
/// Returns only the content of the section, for a page with several graphs. This graph has no line
/// for the moment shown in the 3D view.
std::string graphFigure(const CheckReport& check, const Words& words);

}  // namespace swept::page
