// SPDX-License-Identifier: Apache-2.0
// Target that does nothing. fuzz/throughput measures with it what libFuzzer itself costs.
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
    return 0;
}
