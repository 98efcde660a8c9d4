// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/accuracy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/accuracy_text.h"
#include "base/number_text.h"

namespace swept {
namespace {

/// Every triangle of the surface lies in the four cells around a grid edge that meets the true
/// surface. The crossing is the point where they meet. No point of the four cells is farther from
/// the crossing than the diagonal of a cell.
constexpr double kDiagonal = std::numbers::sqrt3;
/// Cell and tolerance as fractions of the accuracy, and the chord tolerance as a fraction of the
/// cell. The diagonal of a cell takes 0.87 of the accuracy, the tolerance 0.1, the chords 0.02, and
/// the thinning of the body 0.01.
constexpr double kCell = 0.5, kTolerance = 0.1, kChordCells = 0.04;
static_assert(kDiagonal * kCell + kTolerance + 1.5 * kChordCells * kCell < 1);

}  // namespace

void setAccuracy(Options& options, double accuracy) {
  if (!(accuracy > 0) || !std::isfinite(accuracy)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the accuracy is " + numberText(accuracy, 6) + " mm; it must be above 0 mm");
  }
  options.cellSize = kCell * accuracy;
  options.tolerance = kTolerance * accuracy;
  options.chordTolerance = kChordCells * *options.cellSize;
}

std::optional<double> accuracyBound(const Report& report) {
  const bool grown =
      std::any_of(report.warnings.begin(), report.warnings.end(),
                  [](const Finding& f) { return f.code == "Offset" || f.code == "Conservative"; });
  if (grown || report.crossings <= 0) return std::nullopt;
  return kDiagonal * report.cellSize + report.chordError + report.bodyDeviation +
         report.positionFilterDistance + report.simplificationDeviation;
}

std::string cellOrAccuracy(double cell) {
  return textOf(4, cell, " mm (an accuracy of ", cell / kCell, " mm)");
}

}  // namespace swept
