// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/enclosure.h"

#include <algorithm>
#include <cmath>

#include "base/accuracy_text.h"
#include "base/number_text.h"
#include "check/mesh_check.h"

namespace swept {

SignRuns findSigns(const SamplerInput& input, const MarkedEdges& marks, const SolidPoint& isSolid,
                   const Prepared& prepared, bool keepCavities, Report& report, RunContext& run) {
  if (!keepCavities) return findOutside(marks, prepared.grid, run);
  const auto note = [&](const char* code, std::int64_t count, const std::string& text) {
    auto& notes = report.warnings;  // this function may run again for the same report
    notes.erase(std::remove_if(notes.begin(), notes.end(),
                               [&](const Finding& f) { return f.code == code; }),
                notes.end());
    notes.push_back({code, count, {}, text});
  };
  if (!prepared.body.closed) {
    note("CavitiesFilled", 1,
         "the part is open, so cavities cannot be distinguished from the outside and were filled; "
         "close the gaps of the part to keep them");
    return findOutside(marks, prepared.grid, run);
  }
  std::vector<std::uint32_t> component;
  SignRuns found = findOutside(marks, prepared.grid, run, &component);
  const std::int64_t opened =
      openCavities(found, component, marks, input.grid, input.body, input.motion, isSolid, run);
  note("CavitiesKept", opened,
       counted(opened, "enclosed cavity was kept as an inner shell",
               "enclosed cavities were kept as inner shells"));
  return found;
}

namespace {

/// Returns 2 * volume / area: about the thickness of a plate, or half the thickness of a rod.
/// Returns 0 for an open body.
double meanThickness(const CheckedBody& body, RunContext& run) {
  if (!body.closed) return 0;
  const MeshCheck check = checkMesh(body.mesh, false, run);
  return check.area > 0 ? 2 * std::abs(check.volume) / check.area : 0;
}

[[noreturn]] void refuseCell(const char* what, const Prepared& prepared, RunContext& run) {
  const double cell = prepared.grid.cell, thickness = meanThickness(prepared.body, run);
  std::string text =
      textOf(3, what, ", because the part is thinner than one cell (", cell, " mm) everywhere");
  if (thickness > 0)
    text += textOf(3, "; the mean thickness of the part is about ", thickness, " mm");
  const double better = thickness > 0 ? std::min(thickness, cell / 2) : cell / 2;
  text += "; use a smaller cell: try " + cellOrAccuracy(better);
  throw Error(Status::InvalidInput, "CellTooLarge", text);
}

}  // namespace

void requireCrossings(const HermiteGrid& hermite, const Prepared& prepared, RunContext& run) {
  if (hermite.crossings.empty()) refuseCell("no grid line meets the part", prepared, run);
}

void requireSurface(const TriMesh& mesh, const Prepared& prepared, RunContext& run) {
  if (mesh.triangles.empty()) refuseCell("no surface could be built", prepared, run);
}

void requireEnclosed(const HermiteGrid& hermite, const Prepared& prepared, Report& report,
                     RunContext& run) {
  requireCrossings(hermite, prepared, run);
  const auto crossings = static_cast<std::int64_t>(hermite.crossings.size());
  if (prepared.body.closed || hermite.sheetEdges == 0) return;
  const double fraction =
      2.0 * static_cast<double>(hermite.sheetEdges) / static_cast<double>(crossings);
  const bool isUnion = !prepared.motion.continuous;
  const std::string text = textOf(3, "the part is open, and ", 100 * fraction,
                                  " % of its surface is thin sheet that encloses no volume");
  if (isUnion && fraction > 0.01) {
    throw Error(Status::InvalidInput, "OpenMesh",
                text + "; close the gaps of the part, or choose a motion that closes them");
  }
  report.warnings.push_back({"OpenSheets",
                             hermite.sheetEdges,
                             {},
                             text + ", which gets a thickness of 0.002 times the cell size; close "
                                    "the gaps of the part if the envelope should be solid there"});
}

}  // namespace swept
