// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/memory.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <fcntl.h>
#include <unistd.h>
#endif

namespace swept {
namespace {

/// Returns the value, in bytes, of a line "name:   1234 kB"; 0 if the file has no such line.
std::uint64_t lineOf(const char* path, const std::string& name) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.compare(0, name.size(), name) == 0) {
      return 1024 * std::strtoull(line.c_str() + name.size(), nullptr, 10);
    }
  }
  return 0;
}

}  // namespace

std::uint64_t residentMemoryBytes() {
#ifdef __linux__
  // This function allocates nothing, because it also runs when the memory may be exhausted.
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  std::array<char, 128> text{};
  const ssize_t length = read(file, text.data(), text.size() - 1);
  close(file);
  const char* resident = length > 0 ? std::strchr(text.data(), ' ') : nullptr;
  if (resident == nullptr) return 0;
  return std::strtoull(resident, nullptr, 10) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
#else
  return 0;
#endif
}

MemoryWatch::MemoryWatch()
    : processPeak_(lineOf("/proc/self/status", "VmHWM:")), most_(residentMemoryBytes()) {
  try {
    thread_ = std::thread([this] { look(); });
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

void MemoryWatch::look() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::milliseconds(kMemoryMilliseconds),
                         [this] { return ended_; })) {
    most_ = std::max(most_.load(), residentMemoryBytes());
  }
}

std::uint64_t MemoryWatch::peakBytes() const {
  const std::uint64_t peak = lineOf("/proc/self/status", "VmHWM:");
  return peak > processPeak_ ? peak : std::max(most_.load(), residentMemoryBytes());
}

void returnFreeMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}
std::uint64_t availableMemoryBytes() { return lineOf("/proc/meminfo", "MemAvailable:"); }
std::uint64_t memoryLimit(const RunContext& run) {
  return run.memoryLimitBytes != 0 ? run.memoryLimitBytes : availableMemoryBytes() / 4 * 3;
}

}  // namespace swept
