// SPDX-License-Identifier: Apache-2.0
// Tests downloads to dictionaries that none of the four devices has: entries that refer to another row of the table of
// limits, and an absent object; node 5.
#include <gtest/gtest.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class AlteredWrites : public testing::Test, public AlteredSlaveBench {};

/// Each entry contains the number of a row in the table of limits. This number is not a length: even with row 2, a
/// download of two bytes to an entry of one byte must be refused.
TEST_F(AlteredWrites, WrongLengthEqualToTheRowNumberInTheLimitsTableIsRefused) {
    verifies<req::CO_SDO_010>();
    description.rows.limits.resize(std::max<std::size_t>(description.rows.limits.size(), 5));
    std::uint16_t row = 2;
    for (const char* command : {"2B", "27", "23"}) {  // writes 2, 3 and 4 bytes to 2001h:1, an UNSIGNED8
        SCOPED_TRACE(row);
        description.rows.limits.at(row) = LimitRow{};
        entry(0x2001, 1).limit = row;
        power_on();
        EXPECT_EQ(send(std::string{"605#"} + command + "01200111000000"), Frames{"585#8001200112000706"});
        EXPECT_EQ(send("605#4001200100000000"), Frames{"585#4F01200100000000"});
        EXPECT_EQ(send("605#2F01200111000000"), Frames{"585#6001200100000000"});
        ++row;
    }
}

TEST_F(AlteredWrites, ParametersCanBeWrittenWhenVerifyConfiguration1020hIsAbsent) {
    verifies<req::CO_VERIFY_002, req::CO_SDO_016>();
    renumber(0x1020, 0x1021);
    power_on();
    EXPECT_EQ(send("605#4020100100000000"), Frames{"585#8020100100000206"});
    EXPECT_EQ(send("605#2321100130750000"), Frames{"585#6021100100000000"});
    EXPECT_EQ(send("605#2F01220008000000"), Frames{"585#6001220000000000"});  // 2201h = 8
    EXPECT_EQ(send("605#2B00230078790000"), Frames{"585#6000230000000000"});  // 2300h = "xy"
    EXPECT_EQ(send("605#4001220000000000"), Frames{"585#4F01220008000000"});
    EXPECT_EQ(send("605#4021100100000000"), Frames{"585#4321100130750000"}) << "1021h is another object";
}

}  // namespace canproof::test
