// SPDX-License-Identifier: Apache-2.0
// Tests the AX188001 when one of its measurements fails, so that the value is NaN (TCS-D-181).
#include <cmath>
#include <limits>

#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001FailedMeasurement = TcsTest;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr int open_circuit = -512;  // FE00h

}  // namespace

TEST_F(Ax188001FailedMeasurement, ColdJunctionThatIsNaNOpensOnlyTheCompensatedChannel) {
    verifies<req::TCS_IN_025>();
    write(0x4030, 1, 2, 0);  // no delay of errors
    write(0x2000, 2, 1, 0);  // channel 2 is not compensated
    const int measured = process_value(2);
    ASSERT_NE(process_value(1), open_circuit);
    inputs.cold_junction = nan;
    set_inputs();
    EXPECT_EQ(read_once(), (Frames{"165:0FF#01F0010100000000"}));
    EXPECT_EQ(process_value(1), open_circuit);
    EXPECT_EQ(field_value(1).value, not_a_number);
    EXPECT_EQ(process_value(2), measured);
    // The channels change their roles.
    write(0x4030, 2, 2, 0);
    write(0x2000, 1, 1, 0);
    EXPECT_NE(process_value(1), open_circuit);
    write(0x2000, 2, 1, 1);
    EXPECT_EQ(process_value(2), open_circuit);
}

TEST_F(Ax188001FailedMeasurement, ChannelHasItsTemperatureAgainWithTheFirstColdJunctionThatIsANumber) {
    verifies<req::TCS_IN_025>();
    inputs.cold_junction = nan;
    set_inputs();
    read_once();
    ASSERT_EQ(process_value(1), open_circuit);
    inputs.cold_junction = 25.0F;
    set_inputs();
    read_once();
    EXPECT_EQ(process_value(1), 4768);  // both ends have 25 degC: 16 * 25 + 4368, by the defaults of 6126h and 6127h
    EXPECT_EQ(read(0x3100).real(), 25.0F);
}

TEST_F(Ax188001FailedMeasurement, ColdJunctionThatIsNaNIsShownAsNaN) {
    verifies<req::TCS_CJ_007>();
    inputs.cold_junction = nan;
    set_inputs();
    read_once();
    EXPECT_TRUE(std::isnan(read(0x3100).real()));
    EXPECT_EQ(read(0x3130).word(), -32768);
}

TEST_F(Ax188001FailedMeasurement, VoltageThatIsNaNIsAnOpenCircuit) {
    verifies<req::TCS_IN_006>();
    write(0x4030, 1, 2, 0);
    inputs.tc_microvolts[0] = nan;
    set_inputs();
    // Like each open circuit, it is detected at the lowest gain: 8 periods after the first reading.
    EXPECT_EQ(settle(), (Frames{"1485:0FF#01F0010100000000"}));
    EXPECT_EQ(process_value(1), open_circuit);
}

TEST_F(Ax188001FailedMeasurement, ProcessorTemperatureAndSupplyThatAreNaNAreFaults) {
    verifies<req::TCS_FD_002, req::TCS_FD_008>();
    write(0x5051, 1, 2, 0);
    write(0x5051, 2, 2, 0);
    inputs.cpu_temperature = nan;
    set_inputs();
    EXPECT_EQ(read_once(), (Frames{"165:0FF#0042010110000000"}));
    inputs.cpu_temperature = 35.0F;
    inputs.supply = nan;
    set_inputs();
    EXPECT_EQ(read_once(), (Frames{"165:0FF#0000000000000000", "165:0FF#0031010210000000"}));
    inputs.supply = 24.0F;
    set_inputs();
    EXPECT_EQ(read_once(), (Frames{"165:0FF#0000000000000000"}));
}

TEST_F(Ax188001FailedMeasurement, InfiniteColdJunctionIsReadAsTheNearerEndOfItsRange) {
    verifies<req::TCS_CJ_006>();
    inputs.cold_junction = std::numeric_limits<float>::infinity();
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x3100).real(), 110.0F);
    inputs.cold_junction = -std::numeric_limits<float>::infinity();
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x3100).real(), -40.0F);
}

}  // namespace canproof::test
