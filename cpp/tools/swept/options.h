// Declares options of the commands with CLI11. Values are converted here, so that every message
// names the option, the value and the allowed values. Help, manual page and completions come from
// the same declarations (manual.h). Throws Error(InvalidInput, "BadOption").
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "base/unless_zero.h"
#include "swept/run_context.h"

namespace swept::cli {

/// Adds an option whose value take() converts. `names`: in the form of CLI11 ("-o,--output").
/// `kind`: the placeholder in the help ("FILE", "MM", or the allowed words separated by |).
CLI::Option* addConverted(CLI::App& app, const std::string& names, const std::string& kind,
                          std::function<void(const std::string&)> take, const std::string& about);
CLI::Option* addText(CLI::App& app, const std::string& names, const std::string& kind,
                     std::string& target, const std::string& about);
CLI::Option* addNumber(CLI::App& app, const std::string& names, const std::string& kind,
                       double& target, const std::string& about);
/// Does the same for a number that need not be given; 0 stands for "not given".
CLI::Option* addNumber(CLI::App& app, const std::string& names, const std::string& kind,
                       std::optional<double>& target, const std::string& about);
std::int64_t wholeNumberOf(const std::string& name, const std::string& text, std::int64_t least,
                           std::int64_t most);
CLI::Option* addInteger(CLI::App& app, const std::string& names, std::int64_t& target,
                        std::int64_t least, std::int64_t most, const std::string& about);
/// Does the same for a number that need not be given; 0 stands for "not given".
template <class T>
CLI::Option* addInteger(CLI::App& app, const std::string& names, std::optional<T>& target,
                        std::int64_t least, std::int64_t most, const std::string& about) {
  const std::string name = names.substr(names.rfind(',') + 1);
  return addConverted(
      app, names, "N",
      [name, &target, least, most](const std::string& value) {
        const auto number = static_cast<T>(wholeNumberOf(name, value, least, most));
        target = unlessZero(std::optional(number));
      },
      about);
}
/// Adds an option that takes `count` words and may be repeated.
void addWords(CLI::App& app, const std::string& name, int count, const std::string& kind,
              std::vector<std::string>& words, const std::string& about);
double numberOf(const std::string& name, const std::string& text);
/// Returns numbers that are separated by commas.
std::vector<double> numbersOf(const std::string& name, const std::string& text);
/// Adds an option for three numbers separated by commas.
CLI::Option* addPoint(CLI::App& app, const std::string& names, Eigen::Vector3d& target,
                      const std::string& about);
/// Adds an option for a unit: mm, cm, m or in. `target` receives mm per unit.
CLI::Option* addUnit(CLI::App& app, const std::string& names, double& target,
                     const std::string& about);

/// Adds the earlier name of the option `name`: it works, but help, manual page and completions
/// leave it out.
void keepEarlierName(CLI::App& app, const std::string& earlier, const std::string& name);
/// Does the same for options `prefix`X of the moving part, which were called --generator-X.
void keepGeneratorNames(CLI::App& app, const std::string& prefix,
                        std::initializer_list<const char*> rests);

/// Options that every command has.
struct CommonOptions {
  std::string report;
  std::optional<int> threads;
  bool quiet = false;
  bool verbose = false;
  bool noClobber = false;
  bool strict = false;
};
void addCommonOptions(CLI::App& app, CommonOptions& options);

/// Throws Error(InvalidInput, "BadOption").
[[noreturn]] void badOption(const std::string& text);

}  // namespace swept::cli
