// Limits that all parts share.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace swept {

/// mm; also of a coordinate. Beyond it an input is taken for one with a wrong unit.
constexpr double kLargestLength = 1e9;
/// Vertices and triangles are numbered with 32 bits.
constexpr std::uint64_t kMaxElements = 2147483647;
/// That a run may be given.
constexpr int kMaxThreads = 4096;

}  // namespace swept
