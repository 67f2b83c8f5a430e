// SPDX-License-Identifier: Apache-2.0
// Target that does nothing: fuzz/throughput compares the cost of libFuzzer itself with it.
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
    return 0;
}
