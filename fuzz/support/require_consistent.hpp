// SPDX-License-Identifier: Apache-2.0
// Checks the invariants of the services of a device, which theorems show for the firmware (properties/proofs). A check
// costs up to a third of a step, so only a sample of the inputs has it (Samples::checked_one_in).
#pragma once

#include <cstdio>

#include "firmware/canopen/node.hpp"
#include "fuzz/support/beside_hook.hpp"
#include "fuzz/support/digest.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

/// Whether the present input is in the sample.
inline bool checks_invariants{true};

/// Decides by the hash of an input whether it is in the sample.
inline void begin_checks(std::uint64_t hash) {
    checks_invariants = samples.is_checked(hash);
}
inline void begin_checks(const std::uint8_t* data, std::size_t size) {
    Digest hash;
    hash.add(ByteView{data, size});
    begin_checks(hash.value());
}

/// Requires that the invariant of every service of a device holds. Called after each frame and each tick. Names on
/// standard error the service whose invariant does not hold.
template <typename Device>
void require_consistent(const Device& device, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    if (!checks_invariants) {
        return;
    }
    const char* const service = device.node().inconsistent_service();
    if (service != nullptr) {
        std::fprintf(stderr, "the invariant of a service does not hold: %s\n", service);
        require(false, service, 0, file, line);
    }
}

}  // namespace canproof::fuzz
