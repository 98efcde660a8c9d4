// Reads lines from a plain, gzip or xz file, one at a time, so a large file needs little memory.
// In:   path (UTF-8). The first bytes determine the compression, not the name.
// Out:  lines without their end (LF or CRLF) and without a UTF-8 byte-order mark.
// Throws Error(InvalidInput, "BadFile") for damaged compression, UTF-16, NUL bytes and lines longer
// than kMaxLineBytes, and Error(ResourceLimit, "FileTooLarge") if the uncompressed text exceeds
// kMaxTextBytes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace swept {

constexpr std::uint64_t kMaxTextBytes = 8ULL << 30;
constexpr std::size_t kMaxLineBytes = 1 << 16;

/// Delivers the uncompressed bytes of a file.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads up to `capacity` bytes. Returns their number, 0 at the end.
  virtual std::size_t read(char* buffer, std::size_t capacity) = 0;
};

std::unique_ptr<ByteSource> openByteSource(const std::string& path);

class LineSource {
 public:
  explicit LineSource(const std::string& path);
  /// Reads the next line. Returns false at the end of the file.
  bool next(std::string& line);
  /// Returns the number of the line that next() read last, counted from 1.
  std::int64_t number() const { return number_; }

 private:
  bool fill();

  std::string path_;
  std::unique_ptr<ByteSource> source_;
  std::string buffer_;
  std::size_t at_ = 0;
  std::uint64_t total_ = 0;
  std::int64_t number_ = 0;
};

}  // namespace swept
