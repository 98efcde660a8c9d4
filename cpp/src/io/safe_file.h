// Writing without ever leaving a half-written file: a temporary beside the target, then a rename.
// In:   target path (UTF-8). Out: the finished file, or the old one untouched and no temporary.
// Throws Error(ExportFailed, ...) that names the folder and the cause.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace swept {

/// Path object for a UTF-8 name, on every system.
std::filesystem::path pathFromUtf8(const std::string& text);

/// Lower-case suffix without the dot ("ply"), empty if there is none.
std::string suffixOf(const std::string& path);

/// Throws Error(ExportFailed) unless a file could be written there now: folder present and
/// writable, target neither a folder nor write-protected. To be called before minutes of computing.
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
  SafeFile(const SafeFile&) = delete;
  SafeFile& operator=(const SafeFile&) = delete;

  std::ofstream& stream() { return stream_; }
  /// Closes, checks that every byte arrived, renames.
  void commit();

 private:
  std::string name_;
  std::filesystem::path target_;
  TemporaryName temporary_;  // goes after the stream is closed
  std::ofstream stream_;
};

}  // namespace swept
