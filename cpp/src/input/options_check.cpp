// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/options_check.h"

#include <string>

#include "base/limits.h"
#include "base/number_text.h"

namespace swept {
namespace {

[[noreturn]] void badOption(const char* name, double value, const std::string& allowed,
                            const char* unit = " mm") {
  throw Error(Status::InvalidInput, "BadOption",
              std::string("the ") + name + " is " + numberText(value, kTellingDigits) + unit +
                  "; allowed: " + allowed);
}

void requireLength(const char* name, double value) {
  if (!(value >= 0 && value <= kMaxLength)) {
    badOption(name, value, "0 (off), or above 0 up to 1e9 mm");
  }
}

}  // namespace

void checkOptions(const Options& options) {
  if (options.cellSize && !(*options.cellSize > 0 && *options.cellSize <= kMaxLength)) {
    badOption("cell size", *options.cellSize,
              "above 0 up to 1e9 mm, or not given (from resolution)");
  }
  if (!options.cellSize && (options.resolution < 4 || options.resolution > 16384)) {
    badOption("resolution", options.resolution, "4 to 16384 cells along the longest side", "");
  }
  requireLength("tolerance", options.tolerance);
  requireLength("offset", options.offset);
  requireLength("position filter", options.positionFilter);
  if (options.chordTolerance && !(*options.chordTolerance > 0)) {
    badOption("chord tolerance", *options.chordTolerance, "above 0 mm up to the size of a cell");
  }
  if (options.weldTolerance && !(*options.weldTolerance >= 0)) {
    badOption("weld tolerance", *options.weldTolerance,
              "0 mm up to a hundredth of the diagonal of the part's bounding box");
  }
}

double chordTolerance(const Options& options, double cell) {
  if (options.chordTolerance && *options.chordTolerance > cell) {
    badOption("chord tolerance", *options.chordTolerance,
              "above 0 mm up to the size of a cell (" + numberText(cell, kTellingDigits) + " mm)");
  }
  return options.chordTolerance.value_or(kChordFraction * cell);
}

double weldTolerance(const Options& options, double diagonal) {
  constexpr double kMaxFraction = 0.01;
  const double most = kMaxFraction * diagonal;
  if (options.weldTolerance && *options.weldTolerance > most) {
    badOption("weld tolerance", *options.weldTolerance,
              "0 mm up to a hundredth of the diagonal of the part's bounding box (" +
                  numberText(most, kTellingDigits) + " mm)");
  }
  return options.weldTolerance.value_or(kWeldFraction * diagonal);
}

}  // namespace swept
