// Manual page and shell completions. Like the help, they are generated from the declarations of the
// options.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace swept::cli {

/// Returns the manual page swept(1) in man macros.
std::string manualPage(const CLI::App& program);
/// `shell`: bash, zsh or fish. Throws Error(InvalidInput, "BadOption") for any other.
std::string completions(const CLI::App& program, const std::string& shell);

}  // namespace swept::cli
