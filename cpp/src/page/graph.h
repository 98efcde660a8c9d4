// The graph of distances over time as an svg element.
// The scale is linear near 0 and logarithmic beyond (asinh), so that the required distance can be
// seen whatever the largest one is. Every curve tells its name when it is pointed at. Colours stand
// in attributes, for readers without style sheets; the page's style changes some of them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "page/rows.h"
#include "page/words.h"

namespace swept::page {

/// A section; empty where the report holds no curves.
std::string graphOf(const Told& told, const Words& words);
/// Its content, of one of several on a page: without the line that follows the 3D view.
std::string graphFigure(const Told& told, const Words& words);

}  // namespace swept::page
