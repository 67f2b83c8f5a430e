// SPDX-License-Identifier: Apache-2.0
// Error counters of a controller with each step and limit (ISO 11898-1), and the text that configures bus faults.
#include "host/sim/bus/fault_confinement.hpp"

#include <gtest/gtest.h>

#include "host/base/input_error.hpp"
#include "host/sim/bus/bus_faults.hpp"

namespace canproof::host::test {

namespace {

FaultConfinement after(unsigned transmit_failures, unsigned receive_failures) {
    FaultConfinement one;
    for (unsigned i = 0; i < transmit_failures; ++i) {
        one.transmit_failed();
    }
    for (unsigned i = 0; i < receive_failures; ++i) {
        one.receive_failed();
    }
    return one;
}

}  // namespace

TEST(FaultConfinement, FailedTransmissionAdds8AndFailedReceptionAdds1ToTheErrorCounter) {
    EXPECT_EQ(after(1, 0).transmit_errors(), 8U);
    EXPECT_EQ(after(1, 0).receive_errors(), 0U);
    EXPECT_EQ(after(0, 1).receive_errors(), 1U);
    EXPECT_EQ(after(0, 1).transmit_errors(), 0U);
    EXPECT_EQ(after(3, 5).transmit_errors(), 24U);
    EXPECT_EQ(after(3, 5).receive_errors(), 5U);
}

TEST(FaultConfinement, EachSuccessfulFrameReducesItsErrorCounterByOneDownToZero) {
    FaultConfinement one = after(1, 2);
    one.transmitted();
    EXPECT_EQ(one.transmit_errors(), 7U);
    EXPECT_EQ(one.receive_errors(), 2U);
    one.received();
    EXPECT_EQ(one.receive_errors(), 1U);
    EXPECT_EQ(one.transmit_errors(), 7U);
    one.received();
    one.received();
    EXPECT_EQ(one.receive_errors(), 0U);
    for (int i = 0; i < 7; ++i) {
        one.transmitted();
    }
    EXPECT_EQ(one.transmit_errors(), 0U);
    FaultConfinement none;
    none.transmitted();
    EXPECT_EQ(none.transmit_errors(), 0U);
}

TEST(FaultConfinement, ErrorStatesChangeAtTheirErrorCounts) {
    EXPECT_EQ(after(0, 95).state(), CanState::error_active);
    EXPECT_EQ(after(0, 96).state(), CanState::warning);
    EXPECT_EQ(after(0, 127).state(), CanState::warning);
    EXPECT_EQ(after(0, 128).state(), CanState::error_passive);
    EXPECT_EQ(after(0, 1000).state(), CanState::error_passive);  // receive errors alone never lead to bus-off
    EXPECT_EQ(after(31, 0).state(), CanState::error_passive);    // the transmit counter is 248
    EXPECT_EQ(after(32, 0).state(), CanState::bus_off);          // the transmit counter is 256
    EXPECT_EQ(after(12, 128).state(), CanState::error_passive);  // the state is the worse of those of both counters
    EXPECT_EQ(after(16, 96).state(), CanState::error_passive);
}

TEST(FaultConfinement, ReceiveCounterOfAPassiveNodeGoesBackTo119) {
    FaultConfinement at_limit = after(0, 128);
    at_limit.received();
    EXPECT_EQ(at_limit.receive_errors(), 119U);
    FaultConfinement below = after(0, 127);
    below.received();
    EXPECT_EQ(below.receive_errors(), 126U);
    EXPECT_EQ(after(0, 1000).receive_errors(), 256U);  // the counter stops there
}

TEST(FaultConfinement, RecoveryFromAForcedBusOffClearsBothErrorCounters) {
    FaultConfinement one = after(3, 100);
    one.switch_off();
    EXPECT_EQ(one.state(), CanState::bus_off);
    EXPECT_EQ(one.transmit_errors(), 256U);
    EXPECT_EQ(one.receive_errors(), 100U);
    one.recover();
    EXPECT_EQ(one.transmit_errors(), 0U);
    EXPECT_EQ(one.receive_errors(), 0U);
}

TEST(BusFaultText, FaultRatesFromZeroToNineTenthsAreAccepted) {
    EXPECT_DOUBLE_EQ(parse_bus_faults("corrupted=0.9").corrupted, 0.9);
    EXPECT_DOUBLE_EQ(parse_bus_faults("lost=0").lost, 0.0);
    EXPECT_EQ(parse_bus_faults("seed=123456789012345678").seed, 123456789012345678U);  // 18 digits
    EXPECT_EQ(parse_bus_faults("").seed, 1U);
    for (const char* wrong : {"corrupted=0.91", "corrupted=", "corrupted=0.1x", "lost=", "bus-off", "bus-off=1e9",
                              "seed=1234567890123456789", "seed=-1", "seed", "=1", "corrupted=0.1,,lost=0.1"}) {
        EXPECT_THROW(parse_bus_faults(wrong), InputError) << wrong;
    }
    try {
        parse_bus_faults("lost=0.1,late=1");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string{error.what()}.rfind("bus fault `late=1` is not understood", 0), 0U) << error.what();
    }
}

TEST(BusFaultText, FaultRatesReportWhetherAnyFaultIsPossible) {
    EXPECT_FALSE(parse_bus_faults("").any());
    EXPECT_FALSE(parse_bus_faults("seed=7").any());
    EXPECT_TRUE(parse_bus_faults("corrupted=0.1").any());
    EXPECT_TRUE(parse_bus_faults("lost=0.1").any());
    EXPECT_TRUE(parse_bus_faults("bus-off=0.1").any());
}

TEST(BusFaultDraws, FaultsOccurAtTheirProbability) {
    BusFaults faults{{0.25, 0.0, 0.5, 3}};
    int corrupted = 0;
    int off = 0;
    for (int i = 0; i < 10000; ++i) {
        corrupted += faults.corrupts() ? 1 : 0;
        EXPECT_FALSE(faults.loses());
        off += faults.switches_off() ? 1 : 0;
    }
    EXPECT_NEAR(corrupted, 2500, 250);
    EXPECT_NEAR(off, 5000, 250);
    for (int i = 0; i < 100; ++i) {
        EXPECT_LT(faults.pick(3), 3U);
    }
}

}  // namespace canproof::host::test
