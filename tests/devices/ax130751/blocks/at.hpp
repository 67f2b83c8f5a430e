// SPDX-License-Identifier: Apache-2.0
// A helper for instants in the tests of the blocks of the AX130751.
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::test {

/// Returns the instant `ms` milliseconds after the start.
inline Instant at(std::uint64_t ms) {
    return Instant{} + milliseconds(ms);
}

}  // namespace canproof::test
