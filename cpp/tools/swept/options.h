// Options of the commands, based on CLI11. Values are converted here, so that each message names
// the option, the value and what is allowed. Help, manual page and completions come from the same
// declarations (manual.h).
// Throws Error(InvalidInput, "BadOption").
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "swept/run_context.h"

namespace swept::cli {

/// Adds an option. `names` has the form of CLI11 ("-o,--output"). `kind` follows the names in the
/// help: "FILE", "MM", or the allowed words separated by |.
CLI::Option* addConverted(CLI::App& app, const std::string& names, const std::string& kind,
                          std::function<void(const std::string&)> take, const std::string& about);
CLI::Option* addText(CLI::App& app, const std::string& names, const std::string& kind,
                     std::string& target, const std::string& about);
CLI::Option* addNumber(CLI::App& app, const std::string& names, const std::string& kind,
                       double& target, const std::string& about);
CLI::Option* addInteger(CLI::App& app, const std::string& names, std::int64_t& target,
                        std::int64_t least, std::int64_t most, const std::string& about);
/// Adds an option that takes `count` words and may be repeated.
void addWords(CLI::App& app, const std::string& name, int count, const std::string& kind,
              std::vector<std::string>& words, const std::string& about);
double numberOf(const std::string& name, const std::string& text);
/// Adds an option that takes three numbers, separated by commas.
CLI::Option* addPoint(CLI::App& app, const std::string& names, Eigen::Vector3d& target,
                      const std::string& about);
/// Adds an option that takes mm, cm, m or in.
CLI::Option* addUnit(CLI::App& app, const std::string& names, double& target,
                     const std::string& about);

/// Options of every command.
struct CommonOptions {
  std::string report;
  std::int64_t threads = 0;
  bool quiet = false;
  bool verbose = false;
  bool noClobber = false;
  bool strict = false;
};
void addCommonOptions(CLI::App& app, CommonOptions& options);

/// Throws the error for wrong usage of the program.
[[noreturn]] void badOption(const std::string& text);

}  // namespace swept::cli
