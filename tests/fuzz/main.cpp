// Entry of the fuzzing programs; FUZZ_TARGET names the function. libFuzzer brings main().
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  swept::fuzz::FUZZ_TARGET(data, size);
  return 0;
}
