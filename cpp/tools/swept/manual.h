// Makes the manual page and the completions. Like the help, they come from the declared options.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace swept::cli {

/// Returns the manual page swept(1), with man macros.
std::string manualPage(const CLI::App& program);
/// Returns the completions for `shell`: bash, zsh or fish. Throws Error(InvalidInput, "BadOption")
/// for other shells.
std::string completions(const CLI::App& program, const std::string& shell);

}  // namespace swept::cli
