// Opens files of any kind for reading. Ordinary files are read from the disk. Pipes, standard input
// and devices, which cannot be read twice, are read into memory as a whole.
// Throws Error(InvalidInput, "BadFile") that names the file and the cause, or
// Error(ResourceLimit, "FileTooLarge") if a pipe delivers too much.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

namespace swept {

struct InputFile {
  std::unique_ptr<std::istream> stream;
  std::uint64_t bytes = 0;
};

InputFile openInput(const std::string& path);

/// Throws Error(InvalidInput, "BadFile").
[[noreturn]] void badFile(const std::string& text);

}  // namespace swept
