// Loops over all cores. Same result for any number of threads: work is cut into items that do not
// depend on the thread count, and items write to places of their own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace swept {

/// body(i) for i in [0, n), one item a task: for items that are each worth microseconds or more.
template <class Body>
void parallelFor(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                    });
}

/// body(begin, end) over blocks of fixed size: for cheap items.
template <class Body>
void parallelBlocks(std::size_t n, std::size_t block, const Body& body) {
  const std::size_t blocks = (n + block - 1) / block;
  parallelFor(blocks, [&](std::size_t b) {
    const std::size_t begin = b * block;
    body(begin, begin + block < n ? begin + block : n);
  });
}

/// Concatenates what use(n, part) appends for n in [0, count), in the order of n.
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

/// Different actions side by side.
template <class... Actions>
void parallelActions(const Actions&... actions) {
  tbb::parallel_invoke(actions...);
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
