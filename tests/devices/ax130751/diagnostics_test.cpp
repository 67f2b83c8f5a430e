// Supply and temperature of the AX130751: what is shown, when it is a fault and what the outputs do then (manual 1.8,
// 3.4.74 to 3.4.84, section 4). Thresholds as shipped: 8 V, 35 V with 5 V of hysteresis; 85 degrees with 25.
#include "support/ax130751_bench.hpp"
#include "support/verifies.hpp"

namespace canproof::test {

namespace {

using Frames = Ax130751Bench::Frames;

class Ax130751Diagnostics : public Ax130751Test {
  protected:
    /// Output 1 at 3 V, output 2 digital and on, the relay on.
    void SetUp() override {
        Ax130751Test::SetUp();
        EXPECT_EQ(write(0x2330, 1, 0, 2), "");
        EXPECT_EQ(write(0x6310, 2, 1020, 2), "");
        EXPECT_EQ(write(0x7300, 1, 3000, 2), "");
        EXPECT_EQ(write(0x6220, 2, 1, 1), "");
        EXPECT_EQ(write(0x6220, 3, 1, 1), "");
        EXPECT_EQ(pass(20), Frames{});
        EXPECT_EQ(driven(), "3.0 V, on, on");
    }
    Frames supply(float volts) {
        inputs.supply = volts;
        Frames frames = set_inputs();
        for (const auto& late : pass(20)) {
            frames.push_back(late.substr(late.find(':') + 1));
        }
        return frames;
    }
    Frames temperature(float degrees) {
        inputs.cpu_temperature = degrees;
        Frames frames = set_inputs();
        for (const auto& late : pass(20)) {
            frames.push_back(late.substr(late.find(':') + 1));
        }
        return frames;
    }
    std::string driven() const {
        const auto& out = device->outputs();
        EXPECT_NE(out.relay_nc, out.relay_no);
        return fmt::format("{:.1f} V, {}, {}", out.out_voltage[0], out.out_on[1] ? "on" : "off",
                           out.relay_nc ? "on" : "off");
    }
};

const Frames supply_fault{"0FF#0031010000000000"};       // 3100h
const Frames temperature_fault{"0FF#0042010000000000"};  // 4200h
const Frames fault_ends{"0FF#0000000000000000"};
const std::string going_on = "3.0 V, on, on";
const std::string all_off = "0.0 V, off, off";

}  // namespace

TEST_F(Ax130751Diagnostics, SupplyAndTemperatureAreShownAsMeasured) {
    verifies<req::AOR_DIAG_001, req::AOR_S_SUPPLY, req::AOR_S_TEMPERATURE, req::AOR_OD_5020, req::AOR_OD_5030>();
    EXPECT_EQ(supply(13.5F), Frames{});
    EXPECT_EQ(read(0x5020, 0), 0x41580000U);  // 13.5 = 1.6875 * 2^3
    EXPECT_EQ(temperature(-20.0F), Frames{});
    EXPECT_EQ(read(0x5030, 0), 0xC1A00000U);  // -20 = -1.25 * 2^4
    supply(36.0F);                            // above the 35 V that 3.4.74 prints
    EXPECT_EQ(read(0x5020, 0), 0x42100000U);  // 36 = 1.125 * 2^5
}

TEST_F(Ax130751Diagnostics, UnderVoltageLastsUntilTheHysteresisIsPassed) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_006, req::AOR_DIAG_007, req::AOR_OD_5022, req::AOR_OD_5024>();
    EXPECT_EQ(supply(8.1F), Frames{});
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(supply(7.9F), supply_fault);
    EXPECT_EQ(driven(), all_off);
    EXPECT_EQ(read(0x1001, 0), 1U);
    EXPECT_EQ(read(0x1003, 0), 1U);
    EXPECT_EQ(read(0x1003, 1), 0x00003100U);
    EXPECT_EQ(supply(12.9F), Frames{});
    EXPECT_EQ(driven(), all_off);
    EXPECT_EQ(supply(13.1F), fault_ends);
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(read(0x1001, 0), 0U);
    EXPECT_EQ(read(0x1003, 0), 0U);
}

TEST_F(Ax130751Diagnostics, OverVoltageLastsUntilTheHysteresisIsPassed) {
    verifies<req::AOR_DIAG_003, req::AOR_DIAG_006, req::AOR_DIAG_007, req::AOR_OD_5023, req::AOR_OD_5024>();
    EXPECT_EQ(supply(34.9F), Frames{});
    EXPECT_EQ(supply(35.1F), supply_fault);
    EXPECT_EQ(driven(), all_off);
    EXPECT_EQ(supply(30.1F), Frames{});
    EXPECT_EQ(driven(), all_off);
    EXPECT_EQ(supply(29.9F), fault_ends);
    EXPECT_EQ(driven(), going_on);
}

TEST_F(Ax130751Diagnostics, OverTemperatureLastsUntilTheHysteresisIsPassed) {
    verifies<req::AOR_DIAG_004, req::AOR_DIAG_006, req::AOR_DIAG_007, req::AOR_OD_5032, req::AOR_OD_5033>();
    EXPECT_EQ(temperature(84.9F), Frames{});
    EXPECT_EQ(temperature(85.1F), temperature_fault);
    EXPECT_EQ(driven(), all_off);
    EXPECT_EQ(read(0x1003, 1), 0x00004200U);
    EXPECT_EQ(temperature(60.1F), Frames{});
    EXPECT_EQ(driven(), all_off);
    EXPECT_EQ(temperature(59.9F), fault_ends);
    EXPECT_EQ(driven(), going_on);
}

TEST_F(Ax130751Diagnostics, ThresholdsAndHysteresisAreTheObjects) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_003, req::AOR_DIAG_004>();
    EXPECT_EQ(write(0x5022, 0, 20, 1), "");
    EXPECT_EQ(write(0x5023, 0, 28, 1), "");
    EXPECT_EQ(write(0x5024, 0, 1, 1), "");
    EXPECT_EQ(supply(19.9F), supply_fault);
    EXPECT_EQ(supply(20.9F), Frames{});
    EXPECT_EQ(supply(21.1F), fault_ends);
    EXPECT_EQ(supply(28.1F), supply_fault);
    EXPECT_EQ(supply(27.1F), Frames{});
    EXPECT_EQ(supply(26.9F), fault_ends);
    EXPECT_EQ(write(0x5032, 0, 50, 1), "");
    EXPECT_EQ(write(0x5033, 0, 2, 1), "");
    EXPECT_EQ(temperature(50.1F), temperature_fault);
    EXPECT_EQ(temperature(48.1F), Frames{});
    EXPECT_EQ(temperature(47.9F), fault_ends);
}

TEST_F(Ax130751Diagnostics, WithoutShutdownTheOutputsGoOn) {
    verifies<req::AOR_DIAG_006, req::AOR_DIAG_007, req::AOR_OD_5025, req::AOR_OD_5034>();
    EXPECT_EQ(write(0x5025, 0, 0, 1), "");
    EXPECT_EQ(supply(7.5F), supply_fault);
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(temperature(90.0F), temperature_fault);
    EXPECT_EQ(driven(), all_off);  // 5034h is still 1
    EXPECT_EQ(write(0x5034, 0, 0, 1), "");
    pass(20);
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(read(0x1003, 0), 2U);
}

TEST_F(Ax130751Diagnostics, WithoutDetectionThereIsNoFault) {
    verifies<req::AOR_DIAG_005, req::AOR_OD_5021, req::AOR_OD_5031>();
    EXPECT_EQ(write(0x5021, 0, 0, 1), "");
    EXPECT_EQ(write(0x5031, 0, 0, 1), "");
    EXPECT_EQ(supply(7.5F), Frames{});
    EXPECT_EQ(temperature(120.0F), Frames{});
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(read(0x1001, 0), 0U);
}

TEST_F(Ax130751Diagnostics, AFaultEndsWhenItsDetectionIsSwitchedOff) {
    verifies<req::AOR_DIAG_005>();
    EXPECT_EQ(supply(7.5F), supply_fault);
    EXPECT_EQ(write(0x5021, 0, 0, 1), "");
    EXPECT_EQ(pass(20).size(), 1U);  // the message of the error that ended
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(read(0x1003, 0), 0U);
}

// Section 4: 7 V and 39 V
TEST_F(Ax130751Diagnostics, BeyondTheHardwaresLimitsNothingIsDriven) {
    verifies<req::AOR_DIAG_008, req::AOR_S_SUPPLY>();
    EXPECT_EQ(write(0x5021, 0, 0, 1), "");
    EXPECT_EQ(write(0x5025, 0, 0, 1), "");
    supply(7.1F);
    EXPECT_EQ(driven(), going_on);
    supply(6.9F);
    EXPECT_EQ(driven(), all_off);
    supply(7.1F);
    EXPECT_EQ(driven(), going_on);
    supply(38.9F);
    EXPECT_EQ(driven(), going_on);
    supply(39.1F);
    EXPECT_EQ(driven(), all_off);
    supply(24.0F);
    EXPECT_EQ(driven(), going_on);
    EXPECT_EQ(read(0x1003, 0), 0U);
}

TEST_F(Ax130751Diagnostics, AfterAShutdownTheOutputRampsFromOff) {
    verifies<req::AOR_DIAG_009>();
    EXPECT_EQ(write(0x2330, 1, 1000, 2), "");  // 0 to 5 V in a second
    pass(3000);
    EXPECT_EQ(driven(), going_on);
    supply(7.5F);
    EXPECT_EQ(driven(), all_off);
    inputs.supply = 24.0F;
    set_inputs();
    pass(300);
    EXPECT_NEAR(device->outputs().out_voltage[0], 1.5, 0.02);  // 300 ms of 5 V/s
    pass(700);
    EXPECT_EQ(driven(), going_on);
}

}  // namespace canproof::test
