// Memory used by the process and available on the machine.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "swept/run_context.h"

namespace swept {

/// Returns the resident size of the process, in bytes; 0 if the system does not report it. Takes
/// microseconds.
std::uint64_t residentMemoryBytes();

/// Measures the largest resident size of the process during the life of this object, whatever part
/// of the process uses the memory. Several watches may run at once, so a watch does not reset the
/// peak that the system keeps. If this peak rises during the life of the watch, it is the result.
/// Otherwise the result is the largest of the sizes that a thread reads every kMemoryMilliseconds.
class MemoryWatch {
 public:
  MemoryWatch();
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;
  /// Returns the largest size so far, in bytes; 0 if the system does not report it.
  std::uint64_t peakBytes() const;

 private:
  void sample();

  std::uint64_t processPeak_;  ///< bytes, peak of the process at construction
  std::atomic<std::uint64_t> largest_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::thread thread_;
};
/// Time between two readings. A reading takes about 10 microseconds, so a watch uses 0.2 % of a
/// core.
constexpr int kMemoryMilliseconds = 5;

/// Returns the memory that the process can take without swapping, in bytes; 0 if not known.
std::uint64_t availableMemoryBytes();
/// Returns the memory limit of a run, in bytes: the limit that the user set, else three quarters of
/// the available memory; 0 if not known.
std::uint64_t memoryLimit(const RunContext& run);

/// Returns free memory to the system. The allocator otherwise keeps what many threads have freed,
/// which can be several times the memory that a run needs. Takes milliseconds; does nothing if the
/// C library has no such call.
void returnFreeMemory();

}  // namespace swept
