// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/input_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "base/safe_file.h"
#include "swept/types.h"

namespace swept {
namespace {

namespace fs = std::filesystem;

// Limit for the bytes of a pipe, which are held in memory: enough for a mesh of 40 million
// triangles. The limit also ends the reading of an endless device.
constexpr std::uint64_t kMaxPipeBytes = 2ULL << 30;

InputFile wholeOf(std::istream& pipe, const std::string& path) {
  std::string text;
  std::array<char, 1 << 16> block{};
  while (pipe.read(block.data(), block.size()) || pipe.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(pipe.gcount()));
    if (text.size() <= kMaxPipeBytes) continue;
    throw Error(Status::ResourceLimit, "FileTooLarge",
                "'" + path + "' gives more than " + std::to_string(kMaxPipeBytes >> 30) +
                    " GiB through a pipe; write the data to a file first");
  }
  const std::uint64_t bytes = text.size();
  return {std::make_unique<std::istringstream>(std::move(text)), bytes};
}

}  // namespace

void badFile(const std::string& text) { throw Error(Status::InvalidInput, "BadFile", text); }

InputFile openInput(const std::string& path) {
  const fs::path name = pathFromUtf8(path);
  std::error_code code;
  const fs::file_status status = fs::status(name, code);
  if (!fs::exists(status)) badFile("'" + path + "' does not exist");
  if (fs::is_directory(status)) badFile("'" + path + "' is a folder, not a file");
  errno = 0;
  auto stream = std::make_unique<std::ifstream>(name, std::ios::binary);
  if (!*stream) {
    badFile("'" + path +
            "' cannot be opened for reading: " + std::system_category().message(errno));
  }
  if (!fs::is_regular_file(status)) return wholeOf(*stream, path);
  const std::uint64_t bytes = fs::file_size(name, code);
  if (code) badFile("'" + path + "' cannot be read: " + code.message());
  return {std::move(stream), bytes};
}

}  // namespace swept
