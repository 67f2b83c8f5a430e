// SPDX-License-Identifier: Apache-2.0
// Target with a planted bug that fuzzing finds quickly: the target compares four bytes of the input one after the
// other.
#include <cstddef>
#include <cstdint>

#include "fuzz/support/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    unsigned fitting = 0;
    if (size >= 4 && data[0] == 0x23) {
        ++fitting;
        if (data[1] == 0x10) {
            ++fitting;
            if (data[2] == 0x17) {
                ++fitting;
                fitting += data[3] == 0x01 ? 1 : 0;
            }
        }
    }
    canproof::fuzz::require(fitting < 4);
    return 0;
}
