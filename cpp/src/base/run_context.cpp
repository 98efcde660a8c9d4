// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/run_context.h"

#include <algorithm>
#include <array>

#include "swept/types.h"

namespace swept {
namespace {
// Fractions of a typical run at which each phase starts and ends, in the order of Phase.
struct Span {
  double start, end;
};
constexpr std::array<Span, kPhaseCount> kSpans{{{0.0, 0.02},
                                                {0.02, 0.05},
                                                {0.05, 0.45},
                                                {0.45, 0.55},
                                                {0.55, 0.8},
                                                {0.8, 0.85},
                                                {0.85, 0.97},
                                                {0.97, 1.0},
                                                {0.05, 0.1},
                                                {0.1, 0.2},
                                                {0.2, 0.8},
                                                {0.8, 0.85},
                                                {1.0, 1.0}}};
}  // namespace

void RunContext::checkpoint(Phase phase, std::uint64_t done, std::uint64_t total) {
  const std::uint64_t passed = checkpoints_.fetch_add(1, std::memory_order_relaxed) + 1;
  if (cancelAt_ && passed >= *cancelAt_) cancel();
  if (isCancelled()) throw Error(Status::Cancelled, "Cancelled", "cancelled by the user");
  const int index = static_cast<int>(phase);
  phase_.store(index, std::memory_order_relaxed);
  const auto [start, end] = kSpans[static_cast<std::size_t>(index)];
  const double part =
      total == 0 ? 0.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  const double value = from_ + (to_ - from_) * (start + (end - start) * part);
  double seen = progress_.load(std::memory_order_relaxed);
  while (seen < value && !progress_.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
}

}  // namespace swept
