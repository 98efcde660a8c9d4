// Files to read, of any kind: those on a disk are read where they stand; pipes, standard input and
// devices, which cannot be read twice, are taken into memory whole.
// Throws Error(InvalidInput, "BadFile") that names the file and the cause,
// Error(ResourceLimit, "FileTooLarge") for a pipe that does not end.
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

}  // namespace swept
