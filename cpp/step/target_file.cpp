// SPDX-License-Identifier: LGPL-2.1-or-later
#include "target_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#ifndef _WIN32
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "swept/types.h"

namespace swept::step {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* code, const std::string& what) {
  throw Error(Status::ExportFailed, code, what);
}

std::string reason(int error) { return std::system_category().message(error); }

fs::path pathOf(const std::string& utf8) {
  return fs::path(reinterpret_cast<const char8_t*>(utf8.c_str()));
}

std::string textOf(const fs::path& path) {
  const auto text = path.u8string();
  return {reinterpret_cast<const char*>(text.data()), text.size()};
}

// Links are followed so that the file behind them is replaced, not the link.
fs::path resolve(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? path : resolved;
}

}  // namespace

TargetFile::TargetFile(const std::string& path) {
  const fs::path wanted = resolve(pathOf(path));
  std::error_code error;
  const fs::file_status status = fs::status(wanted, error);
  if (fs::is_directory(status)) fail("NotAFile", "'" + path + "' is a folder; give a file name");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    fail("NotAFile",
         "'" + path + "' is a device or another special file; give the name of a normal file");
  }
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    fail("MissingFolder",
         "the folder '" + textOf(folder) + "' does not exist; create it or choose another");
  }
#ifndef _WIN32
  if (fs::exists(status) && ::access(wanted.c_str(), W_OK) != 0) {
    fail("NotWritable", "'" + path + "' cannot be replaced: " + reason(errno));
  }
#endif
  target_ = textOf(wanted);
  // A short name of its own: the target's name may already be as long as the file system allows.
  std::string pattern = textOf(folder / ".swept-XXXXXX") + "." + suffixOf(path);
#ifdef _WIN32
  pattern.replace(pattern.find("XXXXXX"), 6, std::to_string(std::rand() % 900000 + 100000));
  temporary_ = pattern;
  if (std::FILE* file = std::fopen(temporary_.c_str(), "wb")) {
    std::fclose(file);
  } else {
    fail("NotWritable", "cannot write in the folder '" + textOf(folder) + "': " + reason(errno));
  }
#else
  const int suffix = static_cast<int>(suffixOf(path).size()) + 1;
  const int handle = ::mkstemps(pattern.data(), suffix);
  if (handle < 0) {
    const int why = errno;
    fail("NotWritable", "cannot write in the folder '" + textOf(folder) + "': " + reason(why));
  }
  // mkstemp makes a private file; the result shall have the mode that a new (or the old) file has.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat old {};
  const mode_t mode = ::stat(wanted.c_str(), &old) == 0 ? (old.st_mode & 07777) : (0666 & ~mask);
  (void)::fchmod(handle, mode);
  ::close(handle);
  temporary_ = pattern;
#endif
}

TargetFile::~TargetFile() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove(pathOf(temporary_), ignored);
}

std::uint64_t TargetFile::size() const {
  std::error_code error;
  const auto bytes = fs::file_size(pathOf(temporary_), error);
  return error ? 0 : bytes;
}

std::uint64_t TargetFile::commit() {
#ifndef _WIN32
  const int handle = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle >= 0) {
    const int failed = ::fsync(handle) != 0 ? errno : 0;
    ::close(handle);
    if (failed != 0 && failed != EINVAL) {
      fail("WriteFailed", "writing '" + target_ + "' failed: " + reason(failed));
    }
  }
#endif
  const std::uint64_t bytes = size();
  std::error_code error;
  fs::rename(pathOf(temporary_), pathOf(target_), error);
  if (error)
    fail("WriteFailed",
         "cannot put the new file in place of '" + target_ + "': " + error.message());
  committed_ = true;
  return bytes;
}

std::string suffixOf(const std::string& path) {
  const std::size_t dot = path.find_last_of("./\\");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string suffix = path.substr(dot + 1);
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

}  // namespace swept::step
