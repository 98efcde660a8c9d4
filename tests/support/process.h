// Functions of the operating system that tests need and base/system.h does not have. No other file
// of the tests calls POSIX. available() says whether the system supports a class.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace swept::test {

/// Returns whether the process runs as the superuser, for whom permissions have no effect.
bool isSuperuser();

/// While this object exists, files that the process writes have a limited size, as on a full
/// disk.
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

/// While this object exists, new files have this permission mask.
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

/// Memory that is taken directly from the system, without the allocator, and given back at once by
/// the destructor. (Under AddressSanitizer, freed memory stays resident for a while.)
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
