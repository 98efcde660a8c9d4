// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/thinned_body.h"

#include "simplify/thin.h"

namespace swept {
namespace {

/// Thinning costs more time than it saves if a run has fewer copies of each triangle than this. An
/// exception are bodies of so many triangles that they have few placements to save memory
/// (plan.cpp).
constexpr double kMinCopiesToThin = 256;
/// At least this fraction of the triangles must be removed. Otherwise thinning would cost accuracy
/// and save hardly any time.
constexpr double kMinSaved = 0.5;

}  // namespace

double bodyThinning(const Prepared& prepared, double cell, const Options& options) {
  return allowedChord(prepared, options, cell) / 2;
}

std::optional<TriMesh> thinnedBody(const Prepared& prepared, const TriMesh& given, double cell,
                                   const Options& options, RunContext& run) {
  const Motion& motion = prepared.motion;
  // Long edges have been split, so that the body has more triangles than the given one.
  const double copies = static_cast<double>(motion.placements.size()) *
                        static_cast<double>(prepared.body.mesh.triangles.size()) /
                        static_cast<double>(given.triangles.size());
  if (copies < kMinCopiesToThin && !exceedsChord(prepared, cell, options)) return {};
  if (prepared.keepRoom || prepared.keepBody) return {};
  // An orientable body may have edges with four triangles, which thinOut() does not accept.
  if (!prepared.body.orientable || !prepared.body.manifold) return {};
  if (options.sources || options.offset > 0 || options.conservative) return {};
  Thinned thinned =
      thinOut(given, bodyThinning(prepared, cell, options), ThinFor::Sweep, Phase::Motion, run);
  const double left = static_cast<double>(thinned.mesh.triangles.size());
  if (left > (1 - kMinSaved) * static_cast<double>(given.triangles.size())) return {};
  return std::move(thinned.mesh);
}

}  // namespace swept
