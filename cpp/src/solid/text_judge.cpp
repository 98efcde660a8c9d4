// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text_judge.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "base/safe_file.h"
#include "solid/model/curved_part.h"
#include "solid/text/step_text.h"

namespace swept::step {

// Without a kernel, only faces are refused that have an edge without length, or an edge that bends
// back to its start.
std::vector<std::int32_t> TextJudge::setModel(const Model& model, RunContext& run) {
  run.checkpoint(Phase::Export);
  const auto isShort = [&](const ModelUse& use) {
    const ModelEdge& edge = model.edges[use.edge];
    const Eigen::Vector3d middle = edge.curve.at(edge.curve.last / 2);
    return !((middle - model.vertices[edge.start].point).norm() > kKernelTolerance);
  };
  std::vector<std::int32_t> failed;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    for (const auto& loop : model.faces[f].loops) {
      if (std::none_of(loop.begin(), loop.end(), isShort)) continue;
      failed.push_back(static_cast<std::int32_t>(f));
      break;
    }
  }
  return failed;
}

std::vector<EdgeCut> TextJudge::findEdgesOffFaces(const Model& /*model*/) { return {}; }

std::vector<std::int32_t> TextJudge::findBadFaces(RunContext& run, double from, double /*to*/) {
  constexpr double kScale = 1e6;
  run.checkpoint(Phase::Export, static_cast<std::uint64_t>(kScale * from),
                 static_cast<std::uint64_t>(kScale));
  return {};
}

std::vector<std::int32_t> TextJudge::findUnreadable(const Model& model, const SolidOptions& options,
                                                    RunContext& run) {
  return curved_.findRefused(model, options, run, [&](const std::string& text, std::size_t count) {
    const StepReader::Answer read = reader_.read(text);
    // If the reader split faces, the order of the faces is lost. Then only the later check of the
    // whole file can find bad faces.
    if (read.check.faces != static_cast<std::int64_t>(count)) return std::vector<std::int32_t>();
    return read.badFaces;
  });
}

std::vector<std::int32_t> TextJudge::findInterfering(const Model& /*model*/, RunContext& run) {
  run.checkpoint(Phase::Export);
  return {};
}

// writeSolid() refuses BREP files, so this function is never called.
void TextJudge::writeBrep(std::ostream& out, RunContext& /*run*/) {
  out.setstate(std::ios::badbit);
}

SolidCheck TextJudge::readBack(const Model& /*model*/, const std::string& file,
                               const std::string& /*name*/, const SolidOptions& /*options*/,
                               SolidFormat /*format*/, RunContext& run) {
  run.checkpoint(Phase::Export, 4, 5);
  std::ifstream stream(pathFromUtf8(file), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return reader_.read(text).check;
}

void TextJudge::guard(const std::function<void()>& work, RunContext& /*run*/) { work(); }

}  // namespace swept::step
