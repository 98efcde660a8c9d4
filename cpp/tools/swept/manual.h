// Manual page and completions, made from the declarations of the options, as the help is.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace swept::cli {

/// swept(1), in man macros.
std::string manualPage(const CLI::App& program);
/// `shell`: bash, zsh or fish. Throws Error(InvalidInput, "BadOption") for another.
std::string completions(const CLI::App& program, const std::string& shell);

}  // namespace swept::cli
