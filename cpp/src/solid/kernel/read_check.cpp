// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/read_check.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <sstream>
#include <utility>

#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"

namespace swept::step {
std::vector<std::int32_t> ReadCheck::findUnreadable(const Model& model, const SolidOptions& options,
                                                    RunContext& run) {
  return curved_.findRefused(model, options, run, [&](const std::string& text, std::size_t count) {
    return read(text, count, run);
  });
}

std::vector<std::int32_t> ReadCheck::read(const std::string& text, std::size_t count,
                                          RunContext& run) {
  std::istringstream stream(text);
  const TopoDS_Shape shape = readStepText(stream, kernel_, run);
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  // If the reader split faces, the order of the faces is lost. Then only the later check of the
  // whole file can find bad faces.
  if (faces.size() != count) return {};
  return findBadFaces(faces, run, 0.3, 0.3);
}

}  // namespace swept::step
