// operator new of this program, which fails on demand and counts the memory that has not been
// freed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace swept::fault {

/// Returns the number of allocations since the last arm(), on all threads.
std::int64_t allocations();
/// Returns the bytes that operator new has returned and that have not been freed.
std::int64_t outstandingBytes();
/// The n-th allocation from now (counted from 1) throws std::bad_alloc. With `andAllLater`, all
/// later ones do too, until disarm(). n = 0: allocations are only counted.
void arm(std::int64_t n, bool andAllLater = false);
void disarm();

}  // namespace swept::fault
