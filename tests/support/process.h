// Functions of the operating system that tests need and base/system.h does not have. No other
// file of the tests calls POSIX. available() says whether the system has them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace swept::test {

/// True for the superuser, whom no permissions stop.
bool isSuperuser();

/// Limits the size of files that this process writes, as a full disk would, while it lives.
class FileSizeLimit {
 public:
  static bool available();
  explicit FileSizeLimit(std::uint64_t bytes);
  ~FileSizeLimit();
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  [[maybe_unused]] std::uint64_t before_ = 0;
  [[maybe_unused]] void (*handler_)(int) = nullptr;
};

/// The mask of new files while it lives.
class FileModeMask {
 public:
  static bool available();
  explicit FileModeMask(unsigned mask);
  ~FileModeMask();
  FileModeMask(const FileModeMask&) = delete;
  FileModeMask& operator=(const FileModeMask&) = delete;

 private:
  [[maybe_unused]] unsigned old_ = 0;
};

/// Memory that is the process's own at once and goes back at once, whatever the allocator keeps:
/// under AddressSanitizer what was freed stays resident for a while.
class ResidentPages {
 public:
  explicit ResidentPages(std::size_t bytes);  ///< throws std::bad_alloc
  ~ResidentPages();
  ResidentPages(const ResidentPages&) = delete;
  ResidentPages& operator=(const ResidentPages&) = delete;

 private:
  std::size_t bytes_;
  void* at_;
};

}  // namespace swept::test
