// SPDX-License-Identifier: LGPL-2.1-or-later
#include "warm_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace swept::python {
namespace {

#ifdef __GLIBC__
/// What the C library lets the end of its heap grow to by itself at most; its largest own blocks.
constexpr int kUsualTrim = 64 << 20, kUsualMaps = 65536;
/// So much free memory may lie at the end of the heap while warm memory waits to be used.
constexpr int kNoTrim = 1 << 30;
#endif
/// Less than this is not worth it.
constexpr std::size_t kMin = std::size_t{8} << 20, kPage = 4096;

}  // namespace

WarmMemory::WarmMemory([[maybe_unused]] std::size_t bytes) {
#ifdef __GLIBC__
  if (bytes < kMin) return;
  // A block of its own would go back to the system when it is freed, and so would the end of the
  // heap.
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
  // What nobody took goes back with the next block that is freed at the end of the heap.
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
