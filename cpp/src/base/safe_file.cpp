// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/safe_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <random>
#include <system_error>

#include "base/system.h"
#include "swept/io.h"
#include "swept/types.h"

namespace swept {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSpaceAdvice =
    "; check the free space, or choose another folder (an old file of this name is unchanged)";

[[noreturn]] void refuse(const std::string& code, const std::string& text) {
  throw Error(Status::ExportFailed, code, text);
}

fs::path folderOf(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

// Follows a symbolic link: the program replaces the file behind the link, not the link.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  const fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real;
}

// Returns a name that is unique on the machine: two runs may write the same target at once.
fs::path temporaryBeside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  std::random_device random;
  const std::string mark = std::to_string(random()) + "-" + std::to_string(counter.fetch_add(1));
  // The name is short, so that it fits even if the target's name nears the file system's limit.
  fs::path name = ".swept-" + mark;
  name += target.extension();
  return folderOf(target) / name;
}

std::string causeOf(int error) {
  return error != 0 ? std::system_category().message(error) : "unknown cause";
}

// Flushes the file to the disk. Some systems report a full disk only at this point.
void syncToDisk(const fs::path& file, const std::string& name) {
  if (const int failed = os::flushToDisk(file); failed != 0) {
    refuse("WriteFailed", "writing '" + name + "' failed: " + causeOf(failed) + kSpaceAdvice);
  }
}

// Closes a stream without an exception: the library may throw from close() if the disk is full.
void closeQuietly(std::ofstream& stream) {
  try {
    stream.close();
  } catch (const std::exception&) {
    stream.setstate(std::ios::badbit);
  }
}

void checkFolder(const std::string& path, const fs::path& folder) {
  std::error_code code;
  if (fs::is_directory(folder, code)) return;
  refuse("MissingFolder", "cannot write '" + path + "': the folder '" + utf8FromPath(folder) +
                              "' does not exist; create it, or choose another folder");
}

void checkOldFile(const std::string& path, const fs::path& target) {
  std::error_code code;
  const fs::file_status status = fs::status(target, code);
  if (!fs::exists(status)) return;
  if (fs::is_directory(status)) {
    refuse("BadTarget", "cannot write '" + path + "': it is a folder; add a file name");
  }
  if (!fs::is_regular_file(status)) {
    refuse("BadTarget",
           "cannot write '" + path +
               "': it is a device or another special file; give the name of an ordinary file");
  }
  const auto anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if ((status.permissions() & anyWrite) == fs::perms::none || !os::mayWrite(target)) {
    refuse("ReadOnly", "cannot write '" + path +
                           "': the file is write-protected; remove the protection or choose "
                           "another name");
  }
}

}  // namespace

fs::path pathFromUtf8(const std::string& text) {
  return fs::path(std::u8string(text.begin(), text.end()));
}

std::string utf8FromPath(const fs::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
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

TemporaryName::~TemporaryName() {
  std::error_code ignored;
  if (!path.empty()) fs::remove(path, ignored);
}

// Throws if the file exists.
void requireAbsent(const std::string& role, const std::string& path) {
  std::error_code code;
  if (!fs::exists(fs::symlink_status(pathFromUtf8(path), code))) return;
  refuse("Exists",
         role + " '" + path +
             "' exists, and this run must not replace existing files; choose another name");
}

void checkTarget(const std::string& path) { const SafeFile probe(path); }

SafeFile::SafeFile(const std::string& path) : name_(path) {
  if (path.empty()) refuse("BadTarget", "the name of the output file is empty; give a name");
  target_ = resolved(pathFromUtf8(path));
  checkFolder(path, folderOf(target_));
  checkOldFile(path, target_);
  temporary_.path = temporaryBeside(target_);
  mode_ = os::createPrivate(temporary_.path);
  if (errno == 0) stream_.open(temporary_.path, std::ios::binary | std::ios::trunc);
  if (!stream_.is_open()) {
    refuse("ReadOnly", "cannot write into the folder '" + utf8FromPath(folderOf(target_)) + "': " +
                           causeOf(errno) + "; choose a folder in which you may create files");
  }
}

SafeFile::~SafeFile() { closeQuietly(stream_); }

void SafeFile::close() {
  if (!stream_.is_open()) return;
  if (stream_.good()) errno = 0;  // else errno may still hold the cause of an earlier failure
  stream_.flush();
  const bool written = stream_.good();
  const int error = errno;
  closeQuietly(stream_);
  if (!written || stream_.fail()) {
    refuse("WriteFailed", "writing '" + name_ + "' failed: " + causeOf(error) + kSpaceAdvice);
  }
}

std::uint64_t SafeFile::commit() {
  close();
  syncToDisk(temporary_.path, name_);
  std::error_code code;
  const auto bytes = fs::file_size(temporary_.path, code);
  const fs::file_status old = fs::status(target_, code);
  const auto wanted = fs::exists(old) ? old.permissions() : static_cast<fs::perms>(mode_);
  if (wanted != fs::perms::none) fs::permissions(temporary_.path, wanted, code);
  fs::rename(temporary_.path, target_, code);
  if (code) {
    refuse("WriteFailed", "'" + name_ + "' could not be replaced: " + code.message() +
                              "; close programs that use it, or choose another name");
  }
  temporary_.path.clear();
  return bytes;
}

}  // namespace swept
