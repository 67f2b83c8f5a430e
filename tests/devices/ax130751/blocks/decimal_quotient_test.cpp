// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/decimal_quotient.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "devices/ax130751/firmware/block_signal.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::ax130751 {

namespace {

constexpr std::array<double, 5> tens{1.0, 10.0, 100.0, 1000.0, 10000.0};

}  // namespace

/// A division of two doubles rounds once (IEEE 754); here the compiler's library or the processor does it.
TEST(Ax130751DecimalQuotient, EqualsTheQuotientOfDoublesForEachInteger16) {
    test::verifies<req::AOR_LT_038, req::AOR_LT_039>();
    for (std::uint32_t digits = 1; digits <= 4; ++digits) {
        for (std::int32_t integer = INT16_MIN; integer <= INT16_MAX; ++integer) {
            ASSERT_EQ(decimal_quotient(integer, digits), static_cast<double>(integer) / tens[digits])
                << integer << " with " << digits << " digits";
        }
    }
}

TEST(Ax130751DecimalQuotient, EqualsTheQuotientOfDoublesForIntegersOfAllSizes) {
    test::verifies<req::AOR_LT_038, req::AOR_LT_039>();
    std::uint32_t next = 1;
    for (int i = 0; i < 100000; ++i) {
        next = (next * 1664525U) + 1013904223U;  // a linear congruential generator
        const auto integer = static_cast<std::int32_t>(next) >> (i % 32);
        for (std::uint32_t digits = 1; digits <= 4; ++digits) {
            ASSERT_EQ(decimal_quotient(integer, digits), static_cast<double>(integer) / tens[digits])
                << integer << " with " << digits << " digits";
        }
    }
    const std::vector<std::int32_t> integers{INT32_MIN, INT32_MIN + 1, INT32_MAX, 1, -1, 9, 10, 99999, 1 << 30};
    for (const std::int32_t integer : integers) {
        for (std::uint32_t digits = 1; digits <= 4; ++digits) {
            ASSERT_EQ(decimal_quotient(integer, digits), static_cast<double>(integer) / tens[digits]) << integer;
        }
    }
}

TEST(Ax130751DecimalQuotient, PhysicalValueHasAtMostFourDigits) {
    test::verifies<req::AOR_LT_038, req::AOR_LT_039>();
    EXPECT_EQ(physical_value(1234, 0), 1234.0);
    EXPECT_EQ(physical_value(1234, 2), 12.34);
    EXPECT_EQ(physical_value(-1234, 4), -0.1234);
    EXPECT_EQ(physical_value(1234, 9), 0.1234);
    EXPECT_EQ(physical_value(0, 4), 0.0);
}

}  // namespace canproof::ax130751
