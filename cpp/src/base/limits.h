// Limits that all parts of the core share.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace swept {

/// Largest length and largest coordinate, in mm. A larger input probably has the wrong unit.
constexpr double kMaxLength = 1e9;
/// Largest number of vertices or of triangles: their indices have 32 bits.
constexpr std::uint64_t kMaxElements = 2147483647;
/// Largest error of a rotation: deviation of the length of its quaternion from 1, or of an entry of
/// R^T R from the identity for its matrix R. Rounding cannot explain a larger error.
constexpr double kRigidLimit = 1e-4;
/// Largest number of threads that a user may give to a run.
constexpr int kMaxThreads = 4096;

}  // namespace swept
