// SPDX-License-Identifier: LGPL-2.1-or-later
// Who may read a file, while it is written and afterwards.
#include "base/safe_file.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

#ifndef _WIN32
#include <sys/stat.h>

#include <filesystem>
#include <string>

namespace swept {
namespace {

using test::TemporaryFolder;

namespace fs = std::filesystem;

unsigned modeOf(const fs::path& file) {
  return static_cast<unsigned>(fs::status(file).permissions()) & 0777U;
}

/// The mask of new files while it lives.
class Mask {
 public:
  explicit Mask(mode_t mask) : old_(::umask(mask)) {}
  ~Mask() { ::umask(old_); }
  Mask(const Mask&) = delete;
  Mask& operator=(const Mask&) = delete;

 private:
  mode_t old_;
};

TEST(SafeFile, OnlyTheOwnerReadsTheTemporary) {
  const TemporaryFolder folder;
  for (const mode_t mask : {mode_t{0022}, mode_t{0000}, mode_t{0077}}) {
    const Mask masked(mask);
    const std::string path = folder.file(std::to_string(mask));
    SafeFile file(path);
    file.stream() << "text";
    EXPECT_EQ(modeOf(file.temporary()), 0600U);
    EXPECT_FALSE(fs::exists(path));
    file.commit();
    EXPECT_EQ(modeOf(path), 0666U & ~mask) << "as any new file";
  }
}

TEST(SafeFile, TheModeOfAnOldFileIsKept) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "old");
  for (const unsigned mode : {0640U, 0600U, 0664U}) {
    fs::permissions(path, static_cast<fs::perms>(mode));
    SafeFile file(path);
    EXPECT_EQ(modeOf(file.temporary()), 0600U);
    file.stream() << mode;
    file.commit();
    EXPECT_EQ(modeOf(path), mode);
    EXPECT_EQ(TemporaryFolder::read(path), std::to_string(mode));
  }
}

}  // namespace
}  // namespace swept

#endif
