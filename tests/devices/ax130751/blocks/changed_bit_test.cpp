// SPDX-License-Identifier: Apache-2.0
// The AX130751 keeps results in RAM so that it need not calculate them again. Tests that a changed bit in such a result
// never leads to a wrong value.
#include <gtest/gtest.h>

#include <limits>

#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

/// Changes each bit of an object in turn. Calls `before` before each change and `check` after it.
template <typename Object, typename Before, typename Check>
void with_each_changed_bit(Object& object, const Before& before, const Check& check) {
    for (std::size_t at = 0; at < sizeof object; ++at) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            before();
            reinterpret_cast<unsigned char*>(&object)[at] ^= static_cast<unsigned char>(1U << bit);
            SCOPED_TRACE(::testing::Message() << "byte " << at << ", bit " << bit);
            check();
        }
    }
}

}  // namespace

TEST(ChangedBit, ChosenSourceIsRightDespiteAFlippedBitInItsCachedResult) {
    verifies<req::AOR_SRC_012>();
    SourceChoice choice;
    for (std::uint8_t number = 1; number <= 6; ++number) {
        with_each_changed_bit(
            choice, [&] { static_cast<void>(choice.follow(3, number)); },
            [&] {
                EXPECT_EQ(choice.follow(3, number).quantity, Quantity::lookup_table);  // Table 4A: 3 is a lookup table
                EXPECT_EQ(choice.follow(3, number).channel, number);
            });
    }
}

TEST(ChangedBit, PhysicalValueIsRightDespiteAFlippedBitInItsCachedResult) {
    verifies<req::AOR_SRC_013>();
    KeptPhysicalValue value;
    with_each_changed_bit(
        value, [&] { static_cast<void>(value.of(1234, 2)); }, [&] { EXPECT_EQ(value.of(1234, 2), 12.34); });
}

TEST(ChangedBit, TenthsOfAMeasuredValueAreRightDespiteAFlippedBitInTheirCachedResult) {
    verifies<req::AOR_SRC_013>();
    KeptTenths value;
    with_each_changed_bit(
        value, [&] { static_cast<void>(value.of(12.34F)); }, [&] { EXPECT_EQ(value.of(12.34F), 12.3); });
}

TEST(ChangedBit, TenthsFollowTheMeasuredValue) {
    verifies<req::AOR_SRC_008>();
    KeptTenths value;
    EXPECT_EQ(value.of(0.0F), 0.0);
    EXPECT_EQ(value.of(27.26F), 27.3);
    EXPECT_EQ(value.of(std::numeric_limits<float>::quiet_NaN()), 0.0);
    EXPECT_EQ(value.of(-12.34F), -12.3);
    EXPECT_EQ(value.of(0.0F), 0.0);
}

}  // namespace canproof::test
