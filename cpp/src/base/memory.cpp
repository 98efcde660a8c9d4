// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/memory.h"

#include <algorithm>
#include <chrono>
#include <exception>

#include "base/system.h"
#include "swept/types.h"

namespace swept {

std::uint64_t residentMemoryBytes() { return os::residentMemory(); }

MemoryWatch::MemoryWatch() : processPeak_(os::peakMemory()), largest_(residentMemoryBytes()) {
  try {
    thread_ = std::thread([this] { sample(); });
  } catch (const std::exception&) {  // no more threads available: the peak is then less exact
  }
}

MemoryWatch::~MemoryWatch() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void MemoryWatch::sample() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::milliseconds(kMemoryMilliseconds),
                         [this] { return ended_; })) {
    largest_ = std::max(largest_.load(), residentMemoryBytes());
  }
}

std::uint64_t MemoryWatch::peakBytes() const {
  const std::uint64_t peak = os::peakMemory();
  return peak > processPeak_ ? peak : std::max(largest_.load(), residentMemoryBytes());
}

void returnFreeMemory() { os::returnFreeMemory(); }
std::uint64_t availableMemoryBytes() { return os::availableMemory(); }
std::uint64_t memoryLimit(const RunContext& run) {
  if (!run.memoryLimitBytes) return availableMemoryBytes() / 4 * 3;
  if (*run.memoryLimitBytes == 0) {
    throw Error(Status::InvalidInput, "BadOption",
                "the memory limit is 0 bytes; allowed: more than 0, or not given (three quarters "
                "of the free memory)");
  }
  return *run.memoryLimitBytes;
}

}  // namespace swept
