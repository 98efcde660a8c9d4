// Writes files so that no half-written file ever remains. The data go to a temporary file beside
// the target, which is then renamed.
// In:   target path (UTF-8). Out: the finished file; or, after a failure, the old file unchanged.
// If the target is a link, the file behind it is replaced. The new file gets the access mode of the
// old one. Only the owner can read the temporary file.
// Throws Error(ExportFailed, "BadTarget" | "MissingFolder" | "ReadOnly" | "WriteFailed") that
// names the file or folder and the cause.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace swept {

/// Convert a UTF-8 name to a path object and back, on every system.
std::filesystem::path pathFromUtf8(const std::string& text);
std::string utf8FromPath(const std::filesystem::path& path);

/// Returns the suffix in lower case without the dot ("ply"); empty if there is none.
std::string suffixOf(const std::string& path);

/// Throws if the file `path` cannot be written now: its folder must exist and be writable, and
/// `path` must not name a folder, a device or a write-protected file. Call it before a long
/// computation.
void checkTarget(const std::string& path);

/// Name of a temporary file. The destructor removes the file, even if the file was created but
/// could not be opened.
struct TemporaryName {
  std::filesystem::path path;  ///< empty: no file to remove
  ~TemporaryName();
};

/// A file that appears under its name only after commit() has succeeded.
class SafeFile {
 public:
  explicit SafeFile(const std::string& path);
  ~SafeFile();  ///< removes the temporary file unless commit() succeeded
  SafeFile(const SafeFile&) = delete;
  SafeFile& operator=(const SafeFile&) = delete;

  /// Returns the stream to write to. It is open from the start.
  std::ofstream& stream() { return stream_; }
  /// Returns the name of the temporary file, for writers that open files themselves and for reading
  /// the file back. It has the suffix of the target.
  std::string temporary() const { return utf8FromPath(temporary_.path); }
  std::string target() const { return utf8FromPath(target_); }
  /// Closes the stream and checks that all bytes were written. commit() calls it as well.
  void close();
  /// Renames the temporary file to the target. Returns the size of the file in bytes.
  std::uint64_t commit();

 private:
  std::string name_;
  std::filesystem::path target_;
  TemporaryName temporary_;  // removed after the stream is closed
  std::ofstream stream_;
  unsigned mode_ = 0;  // access mode of the finished file if it replaces no old file
};

}  // namespace swept
