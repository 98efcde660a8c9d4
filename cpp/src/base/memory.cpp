// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/memory.h"

#include <fstream>
#include <string>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace swept {
namespace {

/// Value in bytes of a line "name:   1234 kB".
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

void resetPeakMemory() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5";
}
std::uint64_t peakMemoryBytes() { return lineOf("/proc/self/status", "VmHWM:"); }
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
