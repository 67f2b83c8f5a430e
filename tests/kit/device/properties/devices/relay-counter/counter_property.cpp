// SPDX-License-Identifier: Apache-2.0
// A property of the counter (section 6 of the data sheet).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <vector>

#include "devices/relay-counter/firmware/edge_counter.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

RC_GTEST_PROP(RelayCounterLaw, CounterCountsEachChangeOfTheInputFromOffToOn, (const std::vector<bool>& inputs)) {
    verifies<req::RC_COUNT_001>("property");
    relay_counter::EdgeCounter counter;
    counter.restart(false);
    std::uint32_t pairs = 0;
    bool before = false;
    for (const bool input : inputs) {
        counter.see(input);
        pairs += !before && input ? 1U : 0U;
        before = input;
    }
    RC_ASSERT(counter.count() == pairs);
}

}  // namespace canproof::test
