// A file that appears whole or not at all: written beside its target, then renamed.
// Throws Error(ExportFailed, "MissingFolder" | "NotAFile" | "NotWritable" | "WriteFailed").
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>

namespace swept::step {

class TargetFile {
 public:
  /// Resolves links and tests the folder by creating the temporary, before anything long is done.
  explicit TargetFile(const std::string& path);
  ~TargetFile();  ///< removes the temporary unless commit() was reached
  TargetFile(const TargetFile&) = delete;
  TargetFile& operator=(const TargetFile&) = delete;

  const std::string& target() const { return target_; }
  const std::string& temporary() const { return temporary_; }
  /// Flushes to the disk and puts the temporary in the target's place. Returns its size in bytes.
  std::uint64_t commit();
  std::uint64_t size() const;

 private:
  std::string target_, temporary_;
  bool committed_ = false;
};

/// Lower-case suffix without the dot.
std::string suffixOf(const std::string& path);

}  // namespace swept::step
