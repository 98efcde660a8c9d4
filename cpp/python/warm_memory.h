// Memory that is at hand before somebody asks for it.
//
// Who allocates a hundred megabytes and fills them spends two thirds of the time in the kernel,
// which hands out fresh pages one by one. A window that is about to copy a large mesh can have the
// pages fetched beforehand: reserve() in the window's thread, whose heap it is, touch() in any
// other, release() in the window's just before the copy, which then gets this memory. Until the
// object goes the heap keeps what is free at its end. Units: bytes. GNU C library only; elsewhere
// nothing happens.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace swept::python {

class WarmMemory {
 public:
  /// Of the heap of the calling thread; small or unavailable: nothing.
  explicit WarmMemory(std::size_t bytes);
  ~WarmMemory();
  WarmMemory(const WarmMemory&) = delete;
  WarmMemory& operator=(const WarmMemory&) = delete;

  /// Fetches the pages. Any thread, not while release() runs.
  void touch();
  /// Leaves the memory to the heap, pages and all. The thread of the constructor.
  void release();
  /// Bytes that are held.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  void* memory_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace swept::python
