// SPDX-License-Identifier: Apache-2.0
// Fuzz target that does nothing. With it, fuzz/throughput measures the time that libFuzzer itself takes.
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
    return 0;
}
