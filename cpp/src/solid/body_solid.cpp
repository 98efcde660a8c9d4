// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/body_solid.h"

#include <utility>

#include "solid/reread.h"

namespace swept::step {

namespace {

// Calls assemble(), and returns its solid if it passes the checks.
template <class Assemble>
std::optional<Built> checked(const HalfEdgeMesh& mesh, const SolidOptions& options, Judge& judge,
                             RunContext& run, const Assemble& assemble) {
  std::optional<Assembly> assembly;
  try {
    judge.guard([&] { assembly = assemble(); }, run);
  } catch (const Error& error) {
    if (error.status() != Status::ExportFailed) throw;
  }
  run.checkpoint(Phase::Export);
  if (!assembly || assembly->deviation > options.tolerance) return std::nullopt;
  if (!rereadComplaint(assembly->check, mesh, options, assembly->meshError).empty())
    return std::nullopt;
  Built built;
  built.facesByKind = std::move(assembly->facesByKind);
  built.deviation = assembly->deviation;
  built.meshError = assembly->meshError;
  return built;
}

}  // namespace

std::optional<Built> makeFromBody(const HalfEdgeMesh& mesh, const SolidOptions& options,
                                  const std::function<bool(std::int64_t)>& fits, Judge& judge,
                                  RunContext& run) {
  auto built =
      checked(mesh, options, judge, run, [&] { return judge.assemble(options, mesh, run); });
  if (built && !fits(built->faceCount())) return std::nullopt;
  return built;
}

std::optional<Built> fillFromBody(const HalfEdgeMesh& mesh, const SolidOptions& options,
                                  std::int64_t mostFaces, Judge& judge, RunContext& run) {
  return checked(mesh, options, judge, run,
                 [&] { return judge.fill(options, mostFaces, mesh, run); });
}

}  // namespace swept::step
