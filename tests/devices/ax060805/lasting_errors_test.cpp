// SPDX-License-Identifier: Apache-2.0
// Tests the NMT state of an AX060805 whose sensor error lasts beyond a reset (manual, 4.2.13, 4.3.45).
#include <gtest/gtest.h>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_errors.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Test fixture that sets up and resets a device whose temperature sensor (4200h) or accelerometer (FF00h) fails.
class Ax060805LastingErrors : public Ax060805Errors {
  protected:
    /// Powers on a new device whose stored parameters have these values of 1029h:2 (Error Behaviour) and 5555h (Start
    /// in Operational Mode). 1029h:1, for communication, has another value.
    void begin(std::uint32_t reaction, bool starts_itself) {
        memory.bytes().assign(4096, 0xFF);
        inputs = {};
        power_on();
        write(0x1029, 1, reaction == 1 ? 2 : 1, 1);
        write(0x1029, 2, reaction, 1);
        write(0x5555, 0, starts_itself ? 1 : 0, 1);
        write(0x1010, 1, 0x65766173, 4);
        power_on();
        pass(1);
    }
    void fail(bool by_heat) {
        if (by_heat) {
            heat(130.0F);
        } else {
            fail_accelerometer();
        }
    }
};

}  // namespace

/// Section 4.2.13: 0 is pre-operational, 1 no change, and 2 stopped. By INC-D-160, the state after a reset of the node
/// is the same as after a reset of the communication.
TEST_F(Ax060805LastingErrors, LastingSensorErrorObeysErrorBehaviour1029hAfterEachReset) {
    verifies<req::INC_ERR_022, req::INC_START_002, req::INC_ERR_011>();
    for (const bool starts_itself : {true, false}) {
        const NmtState unchanged = starts_itself ? NmtState::operational : NmtState::pre_operational;
        const std::vector<NmtState> states{NmtState::pre_operational, unchanged, NmtState::stopped};
        for (std::uint32_t reaction = 0; reaction <= 2; ++reaction) {
            for (const bool by_heat : {true, false}) {
                begin(reaction, starts_itself);
                EXPECT_EQ(device->state(), unchanged);
                fail(by_heat);
                EXPECT_EQ(device->state(), states[reaction]) << "1029h:2 = " << reaction << ": the error begins";
                for (const char* reset : {"000#8200", "000#8100", "000#8200"}) {
                    const Frames frames = send(reset);
                    ASSERT_FALSE(frames.empty());
                    EXPECT_EQ(frames[0], "77F#00");
                    pass(50);
                    EXPECT_EQ(device->state(), states[reaction])
                        << "1029h:2 = " << reaction << ", heat " << by_heat << ", 5555h " << starts_itself << reset;
                }
            }
        }
    }
}

TEST_F(Ax060805LastingErrors, SensorErrorThatHasEndedDoesNotStopTheNodeAtTheNextReset) {
    verifies<req::INC_ERR_022>();
    for (const bool by_heat : {true, false}) {
        begin(2, true);
        fail(by_heat);
        EXPECT_EQ(device->state(), NmtState::stopped);
        heat(25.0F);
        fail_accelerometer(false);
        EXPECT_EQ(device->state(), NmtState::stopped) << "the end of an error changes no state";
        send("000#8200");
        pass(1);
        EXPECT_EQ(device->state(), NmtState::operational);
    }
}

/// LSS takes the node-ID away (FFh) and gives the node the node-ID 5, after the error has ended.
TEST_F(Ax060805LastingErrors, SensorErrorThatEndsWhileTheNodeHasNoNodeIdDoesNotStopIt) {
    verifies<req::INC_ERR_022>();
    for (const bool by_heat : {true, false}) {
        for (const bool ends : {true, false}) {
            begin(2, true);
            fail(by_heat);
            EXPECT_EQ(device->state(), NmtState::stopped);
            for (const char* request : {"7E5#0401", "7E5#11FF", "7E5#0400"}) {
                send(request);
            }
            EXPECT_EQ(device->state(), NmtState::initialising);
            if (ends) {
                heat(25.0F);
                fail_accelerometer(false);
            }
            for (const char* request : {"7E5#0401", "7E5#1105", "7E5#0400"}) {
                send(request);
            }
            pass(1);
            EXPECT_EQ(device->state(), ends ? NmtState::operational : NmtState::stopped) << "heat " << by_heat;
        }
    }
}

}  // namespace canproof::test
