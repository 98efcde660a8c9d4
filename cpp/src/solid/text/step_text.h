// Writes a Model as a STEP file (ISO 10303-21).
// In:      Model.
// Out:     one product with a solid for each outer shell (cavities are inner shells), unit mm,
//          names, colour and author. Points have 9 decimals (1e-9 mm), directions 13 digits.
// Cost:    O(model). Throws Error(Cancelled). A full disk sets the error state of the stream.
// Why:     The translator of the kernel takes a minute and three times the bytes for 100,000 faces.
// Parameter curves are left out, because readers compute them.
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
                   const SolidOptions& options, RunContext& run);

/// With this many plane faces or more, the file contains only their corners (FACETED_BREP). Such a
/// file has less than half of the bytes and is read in half of the time.
constexpr std::int64_t kManyFaces = 20000;

/// Returns whether all faces are plane.
bool isFlat(const Model& model);

/// Returns whether the file contains only the corners of the faces: all are plane, there are at
/// least kManyFaces, and the solid has no cavities.
bool isFaceted(const Model& model);

/// Returns the accuracy (mm) that the file states: how far vertices and edges may lie from their
/// surfaces.
double statedAccuracy(const Model& model);

}  // namespace swept::step
