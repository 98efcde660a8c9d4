// Writes one row of a clearance report as JSON, for one moving body or for mechanisms.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/report_json.h"
#include "swept/clearance.h"

namespace swept::clearance {

Json rowJson(const NeighbourClearance& row);

}  // namespace swept::clearance
