// SPDX-License-Identifier: Apache-2.0
// Tests the effects of a reset of the AX188001 on its converters, and the faults that prevent its self-start.
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001Resets : public TcsTest {
  protected:
    int gain(int channel) const { return device->outputs().tc_gain[static_cast<std::size_t>(channel - 1)]; }
};

}  // namespace

/// 18,500 uV is below the full scale of gain 128 (19,531 uV) but above 90 % of it. So a converter at a lower gain does
/// not raise its gain.
TEST_F(Ax188001Resets, ResetNodeSetsTheHighestGainButResetCommunicationKeepsTheGain) {
    verifies<req::TCS_IN_002, req::TCS_IN_004, req::CO_NMT_005>();
    for (const int channel : {1, 2}) {
        for (const char* reset : {"000#827F", "000#817F"}) {
            microvolts(channel, 60000.0);
            settle();
            EXPECT_EQ(gain(channel), 32);
            microvolts(channel, 18500.0);
            settle();
            EXPECT_EQ(gain(channel), 64);
            send(reset);
            EXPECT_EQ(gain(channel), reset[5] == '1' ? 128 : 64) << channel << reset;
            EXPECT_EQ(gain(3 - channel), 128);
        }
    }
}

/// Mains hum is added to one reading and subtracted from the next. In the first reading after each reset it must have
/// the same sign.
TEST_F(Ax188001Resets, MainsHumHasTheSameSignInTheFirstReadingAfterEachReset) {
    verifies<req::TCS_IN_006, req::TCS_IN_007, req::CO_NMT_005>();
    inputs.tc_hum[1] = 1.0e6F;
    inputs.mains_frequency = 50;  // the filter is set to 60 Hz: 1330 uV remain
    inputs.tc_microvolts[1] = 5000.0F;
    power_on();
    const std::uint32_t first = read(0x2010, 2).value;
    send("000#817F");
    EXPECT_EQ(read(0x2010, 2).value, first);
    read_once();
    EXPECT_NE(read(0x2010, 2).value, first);
    send("000#817F");
    EXPECT_EQ(read(0x2010, 2).value, first);
}

/// Without the reset, the next reading would be due at 165 ms.
TEST_F(Ax188001Resets, NextReadingComes165MillisecondsAfterAReset) {
    verifies<req::TCS_IN_001, req::CO_NMT_005>();
    pass(100);
    send("000#817F");
    heat(1, 100.0);
    pass(164);
    EXPECT_EQ(process_value(1), 4768) << "25 degrees, read before the boot-up message";
    pass(1);
    EXPECT_EQ(process_value(1), 100 * 16 + 4368);
}

/// While a fault of a channel is active, 1029h:2 (error behaviour) has priority over the self-start.
TEST_F(Ax188001Resets, EachActiveChannelFaultPreventsTheSelfStart) {
    verifies<req::TCS_START_005, req::TCS_ERR_010, req::TCS_ERR_023>();
    for (const int channel : {1, 2}) {
        for (const double celsius : {130.0, -30.0, 0.0}) {  // 0: an open circuit
            memory.bytes().assign(1024, 0xFF);
            inputs = {};
            power_on();
            write(0x4030, channel, 2, 0);
            EXPECT_EQ(write(0x1029, 2, 1, 0), 0U);  // 1029h:2 error behaviour: pre-operational
            EXPECT_EQ(write(0x5555, 0, 1, 1), 0U);
            EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
            EXPECT_EQ(power_on(), (Frames{"77F#00", "1FF#A012A012"}));
            if (celsius == 0.0) {
                cut(channel);
            } else {
                heat(channel, celsius);
            }
            settle();
            ASSERT_EQ(listed().size(), 1U) << channel << ' ' << celsius;
            EXPECT_EQ(device->state(), NmtState::pre_operational);
            EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
            EXPECT_EQ(device->state(), NmtState::pre_operational) << channel << ' ' << celsius;
            EXPECT_EQ(pass(3000), Frames{});
        }
    }
}

/// 1029h:2 (error behaviour) sets the reaction to faults of the channels, 1029h:3 the reaction to faults of the unit.
/// The test gives them opposite reactions, so that it fails if the device uses the wrong sub-index.
TEST_F(Ax188001Resets, LastingFaultObeysTheErrorBehaviour1029hOfItsOwnErrorClass) {
    verifies<req::TCS_START_005, req::TCS_ERR_010, req::TCS_ERR_023, req::TCS_T_REACTION>();
    const auto begin = [this](int fault) {
        switch (fault) {
            case 0:
                return heat(1, 130.0);
            case 1:
                return heat(2, -30.0);
            case 2:
                return cut(2);
            case 3:
                inputs.cpu_temperature = 120.0F;
                break;
            case 4:
                inputs.supply = 60.0F;
                break;
            default:
                inputs.supply = 8.0F;
                break;
        }
        return set_inputs();
    };
    for (int fault = 0; fault < 6; ++fault) {
        const int own = fault < 3 ? 2 : 3;
        for (const auto& [reaction, state] :
             {std::pair{0U, NmtState::pre_operational}, {1U, NmtState::operational}, {2U, NmtState::stopped}}) {
            memory.bytes().assign(1024, 0xFF);
            inputs = {};
            power_on();
            for (const int sub : {1, 2}) {
                write(0x4030, sub, 2, 0);
                write(0x5051, sub, 2, 0);
            }
            EXPECT_EQ(write(0x1029, own, 1, reaction), 0U);
            EXPECT_EQ(write(0x1029, 5 - own, 1, reaction == 1U ? 2 : 1), 0U);
            EXPECT_EQ(write(0x5555, 0, 1, 1), 0U);
            EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
            power_on();
            begin(fault);
            settle();
            EXPECT_EQ(device->state(), state) << "fault " << fault << " begins";
            send("000#827F");
            EXPECT_EQ(device->state(), state) << "fault " << fault << ", 1029h:" << own << " = " << reaction;
        }
    }
}

}  // namespace canproof::test
