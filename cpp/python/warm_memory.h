// Reserves memory and fetches its pages before a large copy needs them.
// A program that allocates and fills a hundred megabytes spends two thirds of the time in the
// operating system, which provides fresh pages one by one. Before a window copies a large mesh,
// another thread can fetch the pages. Order of calls: the constructor in the window's thread, whose
// heap provides the memory; touch() in any other thread; release() in the window's thread directly
// before the copy, which then gets this memory. Until the object is destroyed, the heap keeps free
// memory at its end. Units: bytes. GNU C library only; no effect elsewhere.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace swept::python {

class WarmMemory {
 public:
  /// Reserves memory in the heap of the calling thread. Does nothing for small sizes, or if the
  /// memory is not available.
  explicit WarmMemory(std::size_t bytes);
  ~WarmMemory();
  WarmMemory(const WarmMemory&) = delete;
  WarmMemory& operator=(const WarmMemory&) = delete;

  /// Fetches the pages. May run in any thread, but not at the same time as release().
  void touch();
  /// Gives the memory back to the heap, together with its pages. Must run in the thread of the
  /// constructor.
  void release();
  /// Returns the number of reserved bytes.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  void* memory_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace swept::python
