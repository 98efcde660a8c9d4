// SPDX-License-Identifier: LGPL-2.1-or-later
// Permissions of a file while it is written and afterwards.
#include "base/safe_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/process.h"
#include "support/temporary_folder.h"

namespace swept {
namespace {

using test::FileModeMask;
using test::TemporaryFolder;

namespace fs = std::filesystem;

unsigned modeOf(const fs::path& file) {
  return static_cast<unsigned>(fs::status(file).permissions()) & 0777U;
}

TEST(SafeFile, OnlyTheOwnerReadsTheTemporary) {
  if (!FileModeMask::available()) GTEST_SKIP() << "files have no modes here";
  const TemporaryFolder folder;
  for (const unsigned mask : {0022U, 0000U, 0077U}) {
    const FileModeMask masked(mask);
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
  if (!FileModeMask::available()) GTEST_SKIP() << "files have no modes here";
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

TEST(SafeFile, NamesWithAnyLettersCanBeWrittenReplacedAndRead) {
  const TemporaryFolder folder;
  for (const char* name :
       {"Hüllkörper.txt", "скорость.txt", "掃引体積.txt", "\U0001F680 a b.txt"}) {
    const std::string path = folder.file(name);
    for (const char* content : {"first", "second"}) {
      SafeFile file(path);
      file.stream() << content;
      EXPECT_EQ(file.commit(), std::string(content).size());
      EXPECT_EQ(TemporaryFolder::read(path), content);
    }
    EXPECT_EQ(utf8FromPath(pathFromUtf8(path)), path);
  }
  EXPECT_EQ(folder.count(), 4U);
}

}  // namespace
}  // namespace swept
