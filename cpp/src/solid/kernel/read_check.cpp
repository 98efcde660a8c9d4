// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/read_check.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <sstream>
#include <utility>

#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"
#include "solid/model/curved_part.h"
#include "solid/text/step_text.h"

namespace swept::step {
std::vector<std::int32_t> ReadCheck::findUnreadable(const Model& model, const StepOptions& options,
                                                    RunContext& run) {
  std::vector<std::int32_t> from;
  const Model part = curvedPart(model, from);
  if (from.empty()) return {};
  std::stringstream stream;
  writeStepText(part, stream, "curved", options, run);
  const std::string text = std::move(stream).str();
  // Compares only the data section, since the header contains the time of writing.
  std::string data = text.substr(std::min(text.size(), text.find("DATA;")));
  if (data != lastText_) {
    answer_ = read(text, from.size(), run);
    lastText_ = std::move(data);
  }
  std::vector<std::int32_t> bad;
  for (const std::int32_t i : answer_) bad.push_back(from[i]);
  return bad;
}

std::vector<std::int32_t> ReadCheck::read(const std::string& text, std::size_t count,
                                          RunContext& run) {
  std::istringstream stream(text);
  const TopoDS_Shape shape = readStepText(stream, kernel_, run);
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  // If the reader split faces, their order is lost. Then only the later check of the whole file can
  // decide.
  if (faces.size() != count) return {};
  return findBadFaces(faces, run, 0.3, 0.3);
}

}  // namespace swept::step
