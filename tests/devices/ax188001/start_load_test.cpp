// SPDX-License-Identifier: Apache-2.0
// Gives an AX188001 the most work of a power-on and of a reset: two sound sets of parameters, of which the newer cannot
// be read to its end. Both channels and the unit have faults that are reported at once. When these tests run on the
// microcontroller, src/target/run_suites measures this work.
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/unreadable_set.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001StartLoad : public UnreadableSet<TcsBench, 1024> {
  protected:
    void SetUp() override {
        power_cycle();
        store_lss_twice();
        EXPECT_EQ(write(0x1017, 0, 2, 500), 0U);  // 1017h (producer heartbeat time): 500 ms
        store_two_sets([this] { EXPECT_EQ(write(0x1010, 1, 4, save), 0U); });
        // The highest gain, with which each of the nine readings of a start is valid.
        heat(1, -205.3);
        heat(2, 300.7);
        inputs.cold_junction = 31.7F;
        inputs.supply = 8.0F;
        inputs.cpu_temperature = 120.0F;
        inputs.can_overrun = true;
        set_inputs();
    }
    void store_lss_twice() {
        for (const char* const request : {"7E5#0401", "7E5#17", "7E5#17", "7E5#0400"}) {
            send(request);
        }
    }
};

/// A device with two sound sets of parameters, with which eight faults are reported at once, each of which stops the
/// node. The settings of LSS are damaged. Each TPDO carries four values.
class Ax188001FaultyStart : public Ax188001StartLoad {
  protected:
    void SetUp() override {
        power_cycle();
        store_lss_twice();
        for (int number = 0; number < 4; ++number) {
            carry_four_values(number);
        }
        write(0x1029, 3, 1, 1);  // 1029h:3 (error behaviour, fault detection): no change of the NMT state
        for (const int sub : {1, 2}) {
            write(0x4030, sub, 2, 0);       // 4030h (TC Error React Delay)
            write(0x5051, sub, 2, 0);       // 5051h (FD Error Response Delay)
            write(0x4000, sub, 2, 0xF556);  // 4000h (TC Low Temperature Warning Threshold): -273.0 degC
            write(0x4010, sub, 2, 0xF5BA);  // 4010h (TC High Temperature Warning Threshold): -263.0 degC
            EXPECT_EQ(write(0x4020, sub, 2, 0xF61E),
                      0U);  // 4020h (TC High Temperature Shutdown Threshold): -253.0 degC
            inputs.tc_microvolts[static_cast<std::size_t>(sub - 1)] = -13333.3F;
        }
        inputs.supply = 8.0F;
        inputs.cpu_temperature = 120.0F;
        inputs.can_overrun = true;
        set_inputs();
        settle();
        for (int cause = 1; cause <= 3; ++cause) {
            EXPECT_EQ(write(0x1029, cause, 1, 2), 0U);  // from the next error on: to stopped
        }
        store_two_sets([this] { EXPECT_EQ(write(0x1010, 1, 4, save), 0U); });
        for (const std::size_t slot : {984U, 1004U}) {  // the last 40 bytes are the two slots of LSS
            faulty.sound.bytes()[slot + 8] ^= 1U;       // the bit rate
        }
    }
    /// Checks what the node sends: the boot-up message and the error messages up to the first one that stops it.
    void expect(const Frames& frames) {
        EXPECT_EQ(frames, (Frames{"77F#00", "0FF#0063010000000000", "0FF#1081010000000000", "0FF#11F0010110000000"}));
        EXPECT_EQ(device->state(), NmtState::stopped);
        send("000#8000");
        EXPECT_EQ(listed().size(), 9U) << "eight faults, the overrun and the damaged settings: the oldest is dropped";
    }
};

}  // namespace

TEST_F(Ax188001StartLoad, PowerOnWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::TCS_ERR_022>();
    const Frames frames = with_unreadable_value([this] { return power_cycle(); });
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#0063010000000000") << "damaged stored values";
    EXPECT_EQ(frames.at(2), "0FF#1081010000000000") << "a lost frame";
    EXPECT_EQ(read(0x1017).value, 0U);
    power_cycle();
    EXPECT_EQ(read(0x1017).value, 500U);
}

TEST_F(Ax188001StartLoad, ResetWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::TCS_ERR_022>();
    double warmer = 0.0;
    const Frames frames = with_unreadable_value([&] {
        // The device has not converted the voltages that the reset finds.
        warmer += 1.3;
        inputs.cold_junction = static_cast<float>(20.0 + warmer);
        heat(1, -205.3 + warmer);
        heat(2, 300.7 - warmer);
        return send("000#817F");
    });
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#0063010000000000") << "damaged stored values";
    EXPECT_EQ(frames.at(2), "0FF#1081010000000000") << "a lost frame";
    EXPECT_EQ(read(0x1017).value, 0U);
    send("000#817F");
    EXPECT_EQ(read(0x1017).value, 500U);
}

// The voltage lies below the range of type J, so that the temperature counts as too low. It is -210 degC, the end of
// the range, which is above both other thresholds.
TEST_F(Ax188001FaultyStart, PowerOnReportsEightFaultsAtOnce) {
    verifies<req::TCS_ERR_022, req::TCS_LIM_001, req::TCS_LIM_017, req::TCS_ERR_010>();
    expect(power_cycle());
}

TEST_F(Ax188001FaultyStart, ResetReportsEightFaultsAtOnce) {
    verifies<req::TCS_ERR_022, req::TCS_LIM_001, req::TCS_LIM_017, req::TCS_ERR_010>();
    power_cycle();
    expect(send("000#817F"));
}

}  // namespace canproof::test
