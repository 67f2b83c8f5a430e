// SPDX-License-Identifier: Apache-2.0
// Tests the access to the cells of a decision table (firmware/base/table_row.hpp).
#include "firmware/base/table_row.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/support/shows_rule.hpp"

namespace canproof::test {

namespace {

struct Row {
    std::uint8_t input;
    std::int16_t answer;
};

}  // namespace

TEST(TableRow, MissingTableRowGivesTheSafeValue) {
    shows_rule("a missing row gives the safe value");
    const Row row{3U, -7};
    const Row* const missing = nullptr;
    EXPECT_EQ(cell_or(&row, &Row::answer, std::int16_t{100}), -7);
    EXPECT_EQ(cell_or(missing, &Row::answer, std::int16_t{100}), 100);
}

}  // namespace canproof::test
