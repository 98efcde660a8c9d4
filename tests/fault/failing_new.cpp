// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fault/failing_new.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace swept::fault {
namespace {

std::atomic<std::int64_t> counted{0}, outstanding{0}, failAt{0};
std::atomic<bool> failLater{false};

bool mustFail() {
  const std::int64_t now = counted.fetch_add(1, std::memory_order_relaxed) + 1;
  const std::int64_t at = failAt.load(std::memory_order_relaxed);
  return at != 0 && (now == at || (now > at && failLater.load(std::memory_order_relaxed)));
}

void* taken(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  outstanding.fetch_add(static_cast<std::int64_t>(malloc_usable_size(memory)),
                        std::memory_order_relaxed);
  return memory;
}

void* take(std::size_t size) {
  if (mustFail()) throw std::bad_alloc();
  return taken(std::malloc(size == 0 ? 1 : size));
}

void* takeAligned(std::size_t size, std::align_val_t alignment) {
  if (mustFail()) throw std::bad_alloc();
  const auto step = static_cast<std::size_t>(alignment);
  return taken(std::aligned_alloc(step, (size + step) / step * step));
}

void giveBack(void* memory) noexcept {
  if (memory == nullptr) return;
  outstanding.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(memory)),
                        std::memory_order_relaxed);
  std::free(memory);
}

}  // namespace

std::int64_t allocations() { return counted; }
std::int64_t outstandingBytes() { return outstanding; }

void arm(std::int64_t n, bool andAllLater) {
  counted = 0;
  failLater = andAllLater;
  failAt = n;
}

void disarm() { failAt = 0; }

}  // namespace swept::fault

void* operator new(std::size_t size) { return swept::fault::take(size); }
void* operator new[](std::size_t size) { return swept::fault::take(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return swept::fault::takeAligned(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return swept::fault::takeAligned(size, alignment);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return swept::fault::take(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
  return operator new(size, tag);
}
void operator delete(void* memory) noexcept { swept::fault::giveBack(memory); }
void operator delete[](void* memory) noexcept { swept::fault::giveBack(memory); }
void operator delete(void* memory, std::size_t) noexcept { swept::fault::giveBack(memory); }
void operator delete[](void* memory, std::size_t) noexcept { swept::fault::giveBack(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { swept::fault::giveBack(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { swept::fault::giveBack(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  swept::fault::giveBack(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  swept::fault::giveBack(memory);
}
