// Model -> text of a STEP file (ISO 10303-21), written straight from the model: the kernel's own
// translator takes a minute and three times the bytes for 100,000 faces. Without parameter curves:
// readers make their own.
// In: Model. Out: one product with a solid for each outer shell (voids as inner shells), unit mm,
// names, colour and author. Points to 1e-9 mm, directions to 13 digits. Cost: O(model).
// Throws Error(Cancelled); a full disk shows in the stream.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "solid/model/model.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

void writeStepText(const Model& model, std::ostream& out, const std::string& fileName,
                   const StepOptions& options, RunContext& run);

/// From so many plane faces on a file holds their corners alone: under half of the bytes, and read
/// in half of the time.
constexpr std::int64_t kManyFaces = 20000;

/// Plane faces only.
bool isFlat(const Model& model);

/// Plane faces without hollow spaces, so many that the file holds their corners alone
/// (FACETED_BREP).
bool isFaceted(const Model& model);

/// mm: how far vertices and edges lie from the surfaces that meet there, as the file states it.
double statedAccuracy(const Model& model);

}  // namespace swept::step
