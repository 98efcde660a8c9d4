// What the process uses and what the machine has.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "swept/run_context.h"

namespace swept {

/// Resident size of the process now, bytes; 0 where the system does not say. Microseconds.
std::uint64_t residentMemoryBytes();

/// Largest resident size of the process while the object lives, with all that others had in it.
/// Nothing in the process is changed for it, so that several may live at once: the system's own
/// peak is taken where it has risen, and where the process has been larger before, a thread looks
/// every kMemoryMilliseconds.
class MemoryWatch {
 public:
  MemoryWatch();
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;
  /// Bytes; 0 where the system does not say.
  std::uint64_t peakBytes() const;

 private:
  void look();

  std::uint64_t processPeak_;  ///< at the start
  std::atomic<std::uint64_t> most_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::thread thread_;
};
/// A look takes some 10 microseconds: 0.2 % of a thread.
constexpr int kMemoryMilliseconds = 5;

/// Memory that could be taken without swapping, bytes; 0 where the system does not tell.
std::uint64_t availableMemoryBytes();
/// What a run may take: its own limit, else three quarters of what is available; 0: not known.
std::uint64_t memoryLimit(const RunContext& run);

/// Hands free memory back to the system: the allocator keeps what many threads have freed, several
/// times what a run needs, until somebody asks. Milliseconds; nothing where there is no such call.
void returnFreeMemory();

}  // namespace swept
