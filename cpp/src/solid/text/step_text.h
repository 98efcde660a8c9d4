// Model -> text of a STEP file (ISO 10303-21), written directly from the model.
// In: Model. Out: one product with a solid for each outer shell (voids as inner shells), unit mm,
// names, colour and author. Points to 1e-9 mm, directions to 13 digits. Cost: O(model). Throws
// Error(Cancelled); a full disk shows in the state of the stream.
// The kernel's own translator takes a minute and three times the bytes for 100,000 faces. Parameter
// curves are left out; readers compute their own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "solid/model/model.h"
#include "swept/run_context.h"
#include "swept/step_export.h"

namespace swept::step {

void writeStepText(const Model& model, std::ostream& out, const std::string& fileName,
                   const StepOptions& options, RunContext& run);

/// With this many plane faces, the file contains their corners alone (FACETED_BREP): less than half
/// of the bytes, read in half of the time.
constexpr std::int64_t kManyFaces = 20000;

/// Plane faces only.
bool isFlat(const Model& model);

/// Plane faces without hollow spaces, so many that the file contains their corners alone.
bool isFaceted(const Model& model);

/// mm: how far vertices and edges lie from the surfaces that meet there, as the file states it.
double statedAccuracy(const Model& model);

}  // namespace swept::step
