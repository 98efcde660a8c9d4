// Selects the part of a model that other programs may read differently: its curved faces.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

/// Returns a model of the curved faces only. Each face has a separate shell, so that a reader keeps
/// their order. `from` receives the indices of these faces in `model`.
Model curvedPart(const Model& model, std::vector<std::int32_t>& from);

}  // namespace swept::step
