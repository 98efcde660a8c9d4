// SPDX-License-Identifier: LGPL-2.1-or-later
#include "warm_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace swept::python {
namespace {

#ifdef __GLIBC__
/// Defaults of the GNU C library, restored after use: kUsualTrim is the largest free space it keeps
/// at the end of its heap before it returns memory to the system, kUsualMaps its largest number of
/// blocks outside the heap.
constexpr int kUsualTrim = 64 << 20, kUsualMaps = 65536;
/// Free space that may remain at the end of the heap while the reserved memory waits to be used.
constexpr int kNoTrim = 1 << 30;
#endif
/// Smaller reservations save too little time.
constexpr std::size_t kMin = std::size_t{8} << 20, kPage = 4096;

}  // namespace

WarmMemory::WarmMemory([[maybe_unused]] std::size_t bytes) {
#ifdef __GLIBC__
  if (bytes < kMin) return;
  // Without these settings, malloc would map a separate block, which free() returns to the system,
  // or free() would return the end of the heap to the system.
  mallopt(M_TRIM_THRESHOLD, kNoTrim);
  mallopt(M_MMAP_MAX, 0);
  memory_ = std::malloc(bytes);
  mallopt(M_MMAP_MAX, kUsualMaps);
  bytes_ = memory_ != nullptr ? bytes : 0;
#endif
}

WarmMemory::~WarmMemory() {
  release();
#ifdef __GLIBC__
  // With the usual setting, memory that nobody used returns to the system with the next block that
  // is freed at the end of the heap.
  if (bytes_ > 0) mallopt(M_TRIM_THRESHOLD, kUsualTrim);
#endif
}

void WarmMemory::touch() {
  auto* bytes = static_cast<volatile char*>(memory_);
  if (bytes == nullptr) return;
  for (std::size_t at = 0; at < bytes_; at += kPage) bytes[at] = 0;
}

void WarmMemory::release() {
  std::free(memory_);
  memory_ = nullptr;
}

}  // namespace swept::python
