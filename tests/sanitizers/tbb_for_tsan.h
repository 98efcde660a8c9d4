// Tells ThreadSanitizer in which order the threads of TBB work; TBB's library is not instrumented.
// The build with ThreadSanitizer, and no other, includes this header before everything else
// (CMakeLists.txt). A forked task sees what its caller did before, and after the join the caller
// sees what the task did. Items of one loop do not see each other, so races between them are found.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <utility>

extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);

namespace tbb {
namespace watched {

inline char forked, joined;

struct Region {
  Region() { __tsan_release(&forked); }
  ~Region() { __tsan_acquire(&joined); }
};
struct Item {
  Item() { __tsan_acquire(&forked); }
  ~Item() { __tsan_release(&joined); }
};

template <class Body>
auto item(const Body& body) {
  return [&body](auto&&... values) {
    const Item here;
    return body(std::forward<decltype(values)>(values)...);
  };
}

}  // namespace watched

template <class Range, class Body>
void watched_for(const Range& range, const Body& body) {
  const auto item = watched::item(body);
  const watched::Region here;
  parallel_for(range, item);
}
template <class Index, class Body>
void watched_for(Index first, Index last, const Body& body) {
  const auto item = watched::item(body);
  const watched::Region here;
  parallel_for(first, last, item);
}
template <class... Bodies>
void watched_invoke(const Bodies&... bodies) {
  const auto call = [](const auto&... items) {
    const watched::Region here;
    parallel_invoke(items...);
  };
  call(watched::item(bodies)...);
}
// TBB's own parallel_reduce would write the values of its parts after the item has ended. This
// cannot be declared to ThreadSanitizer.
template <class Range, class Value, class Body, class Join>
Value reduce_parts(Range range, const Value& start, const Body& body, const Join& join, int depth) {
  if (depth == 0 || !range.is_divisible()) return body(range, start);
  Range right(range, split());
  Value one = start, other = start;
  watched_invoke([&] { one = reduce_parts(range, start, body, join, depth - 1); },
                 [&] { other = reduce_parts(right, start, body, join, depth - 1); });
  return join(one, other);
}
template <class Range, class Value, class Body, class Join>
Value watched_reduce(const Range& range, const Value& start, const Body& body, const Join& join) {
  return reduce_parts(range, start, body, join, 4);
}
// Sorts on one thread: the tasks of TBB's parallel_sort are made inside TBB and cannot be wrapped.
template <class Iterator, class... Less>
void watched_sort(Iterator first, Iterator last, const Less&... less) {
  std::sort(first, last, less...);
}
template <class Container>
void watched_sort(Container& values) {
  std::sort(values.begin(), values.end());
}

}  // namespace tbb

#define parallel_for watched_for
#define parallel_reduce watched_reduce
#define parallel_invoke watched_invoke
#define parallel_sort watched_sort
