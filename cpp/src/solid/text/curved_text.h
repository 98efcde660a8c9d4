// Finds the curved faces of a model that a reader of STEP text refuses.
// In:      a model, and a function that reads a text and returns the indices of the faces that it
//        refuses.
// Out:     indices into Model::faces.
// Cost:    that of the function. It is not called again while the curved faces stay the same.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "solid/model/curved_part.h"
#include "solid/text/step_text.h"

namespace swept::step {

class CurvedText {
 public:
  /// `read(text, count)` returns the refused faces of a text with `count` faces.
  template <class Read>
  std::vector<std::int32_t> findRefused(const Model& model, const SolidOptions& options,
                                        RunContext& run, const Read& read) {
    std::vector<std::int32_t> from;
    const Model part = curvedPart(model, from);
    if (from.empty()) return {};
    std::stringstream stream;
    writeStepText(part, stream, "curved", options, run);
    const std::string text = std::move(stream).str();
    // Compares only the data section, since the header contains the time of writing.
    std::string data = text.substr(std::min(text.size(), text.find("DATA;")));
    if (data != lastText_) {
      answer_ = read(text, from.size());
      lastText_ = std::move(data);
    }
    std::vector<std::int32_t> bad;
    for (const std::int32_t i : answer_) bad.push_back(from[static_cast<std::size_t>(i)]);
    return bad;
  }

 private:
  // The last query and its answer, because the same faces are checked again if only facets have
  // changed.
  std::string lastText_;
  std::vector<std::int32_t> answer_;
};

}  // namespace swept::step
