// The function that libFuzzer calls; its main() is in the library. FUZZ_TARGET names the
// function under test.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  swept::fuzz::FUZZ_TARGET(data, size);
  return 0;
}
