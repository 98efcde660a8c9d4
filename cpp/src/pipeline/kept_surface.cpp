// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/kept_surface.h"

#include <sstream>

#include "check/mesh_check.h"
#include "pipeline/require_passed.h"
#include "simplify/simplify.h"

namespace swept {
namespace {

constexpr int kHalvings = 6;

void cutOnce(Result& result, double tolerance, RunContext& run) {
  const Simplifier& kept = *result.kept;
  Report& report = result.report;
  if (tolerance > 0) {
    Simplified cut = kept.simplifyTo(tolerance, run);
    result.mesh = std::move(cut.mesh);
    result.contactTime = std::move(cut.contactTime);
    result.featureEdges = std::move(cut.featureEdges);
    result.sources = std::move(cut.sources);
    report.simplificationDeviation = cut.deviation;
  } else {
    result.mesh = kept.mesh();
    result.contactTime = kept.contactTime();
    result.featureEdges = kept.featureEdges();
    result.sources = kept.sources();
    report.simplificationDeviation = 0;
  }
  report.check = checkMesh(result.mesh, run);
}

}  // namespace

// A tolerance as large as the body may turn its surface inside out. In this case the function
// halves the tolerance repeatedly and finally uses 0, because the surface without simplification
// has passed the check.
void cutKept(Result& result, double tolerance, RunContext& run) {
  auto& notes = result.report.warnings;
  std::erase_if(notes, [](const Finding& f) { return f.code == "SimplifiedLess"; });
  double used = tolerance;
  cutOnce(result, used, run);
  for (int n = 1; n <= kHalvings && used > 0 && !result.report.check.passes(); ++n) {
    used = n < kHalvings ? used / 2 : 0;
    cutOnce(result, used, run);
  }
  requirePassed(result.report.check, "the simplified envelope", result.report.cellSize);
  if (used == tolerance) return;
  std::ostringstream text;
  text.precision(3);
  text << "within a tolerance of " << tolerance
       << " mm, parts of the surface would turn inside out; the surface was "
       << (used > 0 ? "simplified within " : "not simplified");
  if (used > 0) text << used << " mm";
  notes.push_back({"SimplifiedLess", 1, {}, text.str()});
}

}  // namespace swept
