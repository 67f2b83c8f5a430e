// SPDX-License-Identifier: Apache-2.0
// Tests instants, durations and sequence numbers (firmware/base).
#include <gtest/gtest.h>

#include "firmware/base/sequence_number.hpp"
#include "firmware/base/time.hpp"
#include "tests/support/shows_rule.hpp"

namespace canproof::test {

TEST(Instants, InstantsAreOrderedByTheirMicroseconds) {
    shows_rule("time neither wraps nor runs backwards");
    const Instant early{1U};
    const Instant late{2U};
    EXPECT_TRUE(late > early);
    EXPECT_FALSE(late > late);
    EXPECT_FALSE(early > late);
}

TEST(Instants, AdditionSaturatesAtTheInstantNever) {
    shows_rule("time neither wraps nor runs backwards");
    EXPECT_TRUE((Instant{UINT64_MAX - 5U} + Duration{4U}) < never);
    EXPECT_TRUE((Instant{UINT64_MAX - 5U} + Duration{6U}) == never);
    EXPECT_TRUE((never + Duration{1U}) == never);
}

TEST(Instants, ElapsedTimeIsNeverNegative) {
    shows_rule("time neither wraps nor runs backwards");
    EXPECT_EQ(elapsed(Instant{3U}, Instant{10U}).us, 7U);
    EXPECT_EQ(elapsed(Instant{10U}, Instant{10U}).us, 0U);
    EXPECT_EQ(elapsed(Instant{10U}, Instant{3U}).us, 0U);
}

TEST(Instants, PeriodicTimeIsDueWhenReachedOrMoreThanAPeriodAhead) {
    shows_rule("a changed bit does not stop a periodic event");
    const Duration period{5U};
    EXPECT_FALSE(is_due(Instant{15U}, period, Instant{10U}));
    EXPECT_FALSE(is_due(Instant{11U}, period, Instant{10U}));
    EXPECT_TRUE(is_due(Instant{10U}, period, Instant{10U}));
    EXPECT_TRUE(is_due(Instant{16U}, period, Instant{10U}));
    EXPECT_TRUE(is_due(never, period, Instant{10U}));
}

TEST(Instants, PeriodicTimeStaysInStepUnlessItWasMissedOrTooFarAhead) {
    shows_rule("a changed bit does not stop a periodic event");
    const Duration period{5U};
    EXPECT_EQ(next_after(Instant{10U}, period, Instant{12U}).us, 15U);
    EXPECT_EQ(next_after(Instant{10U}, period, Instant{14U}).us, 15U);
    EXPECT_EQ(next_after(Instant{10U}, period, Instant{15U}).us, 20U) << "the time 15 is missed";
    EXPECT_EQ(next_after(Instant{10U}, period, Instant{16U}).us, 21U);
    EXPECT_EQ(next_after(Instant{16U}, period, Instant{10U}).us, 15U) << "too far ahead";
    EXPECT_EQ(next_after(never, period, Instant{10U}).us, 15U);
}

TEST(SequenceNumbers, SequenceNumberWrapsAfterTheHighest) {
    shows_rule("of two copies the newer is used");
    EXPECT_TRUE(is_newer(8U, 7U));
    EXPECT_FALSE(is_newer(7U, 8U));
    EXPECT_FALSE(is_newer(7U, 7U));
    EXPECT_TRUE(is_newer(0U, 0xFFFFFFFFU));
    EXPECT_FALSE(is_newer(0xFFFFFFFFU, 0U));
}

}  // namespace canproof::test
