// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/safe_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <random>

#include "swept/types.h"

namespace swept {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& code, const std::string& text) {
  throw Error(Status::ExportFailed, code, text);
}

fs::path folderOf(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

// Unique within the machine: two runs may write the same target at the same time.
fs::path temporaryBeside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  std::random_device random;
  const std::string mark = std::to_string(random()) + "-" + std::to_string(counter.fetch_add(1));
  // Short name: a target whose own name is close to the limit of the file system still works.
  return folderOf(target) / (".swept-" + mark + ".part");
}

std::string causeOf(int error) { return error != 0 ? std::strerror(error) : "unknown cause"; }

}  // namespace

fs::path pathFromUtf8(const std::string& text) {
  return fs::path(std::u8string(text.begin(), text.end()));
}

std::string suffixOf(const std::string& path) {
  const std::u8string suffix = pathFromUtf8(path).extension().u8string();
  if (suffix.size() < 2) return {};
  std::string result(suffix.begin() + 1, suffix.end());
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

void checkTarget(const std::string& path) {
  const fs::path target = pathFromUtf8(path);
  const fs::path folder = folderOf(target);
  std::error_code code;
  if (path.empty()) refuse("BadTarget", "the name of the output file is empty");
  if (!fs::is_directory(folder, code)) {
    refuse("MissingFolder", "cannot write '" + path + "': the folder '" + folder.string() +
                                "' does not exist; create it or choose another");
  }
  const fs::file_status status = fs::status(target, code);
  if (fs::is_directory(status)) {
    refuse("BadTarget", "cannot write '" + path + "': it is a folder; add a file name");
  }
  if (fs::exists(status)) {
    const auto anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if ((status.permissions() & anyWrite) == fs::perms::none) {
      refuse("ReadOnly", "cannot write '" + path +
                             "': the file is write-protected; "
                             "remove the protection or choose another name");
    }
  }
  // Permission bits do not tell the whole truth (read-only mounts, full quotas): try it.
  const TemporaryName probe{temporaryBeside(target)};
  errno = 0;
  const std::ofstream stream(probe.path, std::ios::binary);
  const int error = errno;
  if (!stream.is_open()) {
    refuse("ReadOnly", "cannot write into the folder '" + folder.string() + "': " + causeOf(error) +
                           "; choose a folder in which you may create files");
  }
}

TemporaryName::~TemporaryName() {
  std::error_code ignored;
  if (!path.empty()) fs::remove(path, ignored);
}

SafeFile::SafeFile(const std::string& path)
    : name_(path), target_(pathFromUtf8(path)), temporary_{temporaryBeside(target_)} {
  checkTarget(path);
  errno = 0;
  stream_.open(temporary_.path, std::ios::binary | std::ios::trunc);
  if (!stream_.is_open()) {
    refuse("WriteFailed", "cannot create a file beside '" + path + "': " + causeOf(errno));
  }
}

void SafeFile::commit() {
  errno = 0;
  stream_.flush();
  const bool written = stream_.good();
  const int error = errno;
  stream_.close();
  if (!written || stream_.fail()) {
    refuse("WriteFailed", "writing '" + name_ + "' failed: " + causeOf(error) +
                              "; the old file, if any, is unchanged");
  }
  std::error_code code;
  fs::rename(temporary_.path, target_, code);
  if (code) {
    refuse("WriteFailed", "cannot put '" + name_ + "' in its place: " + code.message());
  }
  temporary_.path.clear();
}

}  // namespace swept
