// SPDX-License-Identifier: LGPL-2.1-or-later
#include "warm_memory.h"

#include <cstdlib>

#include "base/system.h"

namespace swept::python {
namespace {

/// A smaller reservation (bytes) would save too little time.
constexpr std::size_t kMin = std::size_t{8} << 20, kPage = 4096;

}  // namespace

WarmMemory::WarmMemory(std::size_t bytes) {
  // OneHeap: malloc takes the memory from the heap. A block outside the heap would go back to the
  // system with free(). KeepFree: free() does not return the end of the heap to the system.
  if (bytes < kMin || !os::setHeap(os::HeapSetting::OneHeap)) return;
  memory_ = std::malloc(bytes);
  os::setHeap(os::HeapSetting::KeepFree);
  bytes_ = memory_ != nullptr ? bytes : 0;
}

WarmMemory::~WarmMemory() {
  release();
  // With the usual setting, unused memory at the end of the heap goes back to the system when the
  // next block there is freed.
  if (bytes_ > 0) os::setHeap(os::HeapSetting::Usual);
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
