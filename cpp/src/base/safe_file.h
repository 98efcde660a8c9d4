// Writing without ever leaving a half-written file: a temporary beside the target, then a rename.
// In:   target path (UTF-8). Out: the finished file, or the old one untouched and no temporary.
// Links are followed, the mode of an old file is kept. Only the owner can read the temporary.
// Throws Error(ExportFailed, "BadTarget" | "MissingFolder" | "ReadOnly" | "WriteFailed") that
// names the file or folder and the cause.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace swept {

/// Path object for a UTF-8 name, and back, on every system.
std::filesystem::path pathFromUtf8(const std::string& text);
std::string utf8FromPath(const std::filesystem::path& path);

/// Lower-case suffix without the dot ("ply"), empty if there is none.
std::string suffixOf(const std::string& path);

/// Throws unless a file could be written there now: folder present and writable, target neither a
/// folder nor a device nor write-protected. To be called before minutes of computing.
void checkTarget(const std::string& path);

/// Name of a file that is removed at the end, also when opening it created it and then failed.
struct TemporaryName {
  std::filesystem::path path;  ///< empty: nothing to remove
  ~TemporaryName();
};

/// A file that appears under its name only when commit() has succeeded.
class SafeFile {
 public:
  explicit SafeFile(const std::string& path);
  ~SafeFile();  ///< removes the temporary if commit() was not reached
  SafeFile(const SafeFile&) = delete;
  SafeFile& operator=(const SafeFile&) = delete;

  /// To write into; open from the start.
  std::ofstream& stream() { return stream_; }
  /// For writers that open files themselves, and for reading back; ends in the target's suffix.
  std::string temporary() const { return utf8FromPath(temporary_.path); }
  std::string target() const { return utf8FromPath(target_); }
  /// Closes the stream and checks that every byte arrived; commit() does so as well.
  void close();
  /// Puts the file in its place. Returns its size in bytes.
  std::uint64_t commit();

 private:
  std::string name_;
  std::filesystem::path target_;
  TemporaryName temporary_;  // goes after the stream is closed
  std::ofstream stream_;
  unsigned mode_ = 0;  // of the finished file where there is no old one
};

}  // namespace swept
