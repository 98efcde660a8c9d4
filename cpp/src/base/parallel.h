// Loops whose items several threads execute. The result is the same for any number of threads: the
// items of work do not depend on the thread count, and each item writes only its own part of the
// output. A failure is the same, too: the loop throws the exception of the failing item with the
// lowest index.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace swept {

/// Calls body(i) for i in [0, n), one task per item. Use it for items that take microseconds or
/// more. An exception of an item leaves the loop only after all tasks have ended. An exception that
/// left its task at once would cancel the nested loops in the other tasks. A cancelled loop returns
/// early without an error, and the code after it would read incomplete results.
template <class Body>
void parallelFor(std::size_t n, const Body& body) {
  std::atomic<std::size_t> failed{n};  // smallest index of an item that failed
  std::mutex mutex;
  std::exception_ptr what;
  const auto guarded = [&](std::size_t i) {
    if (i > failed.load(std::memory_order_relaxed)) return;
    try {
      body(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (i >= failed.load(std::memory_order_relaxed)) return;
      failed.store(i, std::memory_order_relaxed);
      what = std::current_exception();
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) guarded(i);
                    });
  if (what) std::rethrow_exception(what);
}

/// Calls body(begin, end) for successive ranges of `block` items. Use it for cheap items.
template <class Body>
void parallelBlocks(std::size_t n, std::size_t block, const Body& body) {
  const std::size_t blocks = (n + block - 1) / block;
  parallelFor(blocks, [&](std::size_t b) {
    const std::size_t begin = b * block;
    body(begin, begin + block < n ? begin + block : n);
  });
}

/// Calls use(n, list) for each n in [0, count); `use` appends values to `list`. Returns all values
/// in the order of n. The values of `block` successive calls go to one list.
template <class T, class Use>
std::vector<T> gather(std::size_t count, std::size_t block, const Use& use) {
  std::vector<std::vector<T>> parts(count / block + 1);
  parallelBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) use(n, parts[begin / block]);
  });
  if (parts.size() == 1) return std::move(parts[0]);
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<T> out;
  out.reserve(total);
  for (auto& part : parts) {
    out.insert(out.end(), part.begin(), part.end());
    std::vector<T>().swap(part);
  }
  return out;
}

/// Runs different actions in parallel.
template <class... Actions>
void parallelActions(const Actions&... actions) {
  const std::array<std::function<void()>, sizeof...(Actions)> all{std::ref(actions)...};
  parallelFor(all.size(), [&](std::size_t i) { all[i](); });
}

/// Replaces counts by their exclusive prefix sums and returns the total.
template <class T>
T exclusiveScan(std::vector<T>& counts) {
  T sum = 0;
  for (T& value : counts) {
    const T count = value;
    value = sum;
    sum += count;
  }
  return sum;
}

}  // namespace swept
