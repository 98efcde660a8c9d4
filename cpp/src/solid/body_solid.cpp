// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/body_solid.h"

#include <utility>

#include "solid/reread.h"

namespace swept::step {

std::optional<Built> makeFromBody(const HalfEdgeMesh& mesh, const SolidOptions& options,
                                  const std::function<bool(std::int64_t)>& fits, Judge& judge,
                                  RunContext& run) {
  std::optional<Assembly> assembly;
  try {
    judge.guard([&] { assembly = judge.assemble(options, mesh, run); }, run);
  } catch (const Error& error) {
    if (error.status() != Status::ExportFailed) throw;
  }
  run.checkpoint(Phase::Export);
  if (!assembly || !fits(assembly->check.faces)) return std::nullopt;
  if (!rereadComplaint(assembly->check, mesh, options).empty()) return std::nullopt;
  if (assembly->deviation > options.tolerance) return std::nullopt;
  Built built;
  built.facesByKind = std::move(assembly->facesByKind);
  built.deviation = assembly->deviation;
  return built;
}

}  // namespace swept::step
