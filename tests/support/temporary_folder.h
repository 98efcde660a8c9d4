// A folder that is deleted at the end of a test.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/safe_file.h"
#include "base/system.h"

namespace swept::test {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int counter = 0;
    const bool memory = std::filesystem::exists("/dev/shm");  // faster for thousands of small files
    const std::filesystem::path parent =
        memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
    do {  // a process that was killed leaves its folders, and a later one may get its number
      path_ = parent /
              ("swept-test-" + std::to_string(os::processId()) + "-" + std::to_string(counter++));
    } while (!std::filesystem::create_directory(path_));
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    // Windows does not remove files that are write-protected.
    for (const auto& entry : std::filesystem::directory_iterator(path_, ignored)) {
      if (entry.is_symlink(ignored)) continue;
      std::filesystem::permissions(entry, std::filesystem::perms::owner_write,
                                   std::filesystem::perm_options::add, ignored);
    }
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const {
    return utf8FromPath(path_ / pathFromUtf8(name));
  }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / pathFromUtf8(name), std::ios::binary) << bytes;
    return file(name);
  }
  static std::string read(const std::string& path) {
    std::ifstream stream(pathFromUtf8(path), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                  std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

}  // namespace swept::test
