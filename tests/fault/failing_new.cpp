// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fault/failing_new.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
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

/// Header before each block, with its start and its size. Not every C library has functions that
/// return both.
struct Block {
  void* start;
  std::size_t size;
};

void* take(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
  if (mustFail()) throw std::bad_alloc();
  void* start = std::malloc(size + alignment + sizeof(Block));
  if (start == nullptr) throw std::bad_alloc();
  const auto first = reinterpret_cast<std::uintptr_t>(start) + sizeof(Block);
  auto* memory = reinterpret_cast<Block*>((first + alignment - 1) / alignment * alignment);
  memory[-1] = {start, size};
  outstanding.fetch_add(static_cast<std::int64_t>(size), std::memory_order_relaxed);
  return memory;
}

void* takeAligned(std::size_t size, std::align_val_t alignment) {
  return take(size, std::max(static_cast<std::size_t>(alignment), alignof(std::max_align_t)));
}

void giveBack(void* memory) noexcept {
  if (memory == nullptr) return;
  const Block block = static_cast<Block*>(memory)[-1];
  outstanding.fetch_sub(static_cast<std::int64_t>(block.size), std::memory_order_relaxed);
  std::free(block.start);
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
