// SPDX-License-Identifier: Apache-2.0
// Tests the accuracy of the outputs of the AX130751 (manual, section 4).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Accuracy : public Ax130751Test {
  protected:
    void SetUp() override {
        Ax130751Test::SetUp();
        start();
        for (int output = 1; output <= 2; ++output) {
            EXPECT_EQ(write(0x2330, output, 0, 2), "");  // no ramps
            EXPECT_EQ(write(0x2331, output, 0, 2), "");
        }
    }
    /// Sets the type of an output, which then has the default scaling of this type, and commands a process value.
    void command(int output, int type, int value) {
        EXPECT_EQ(write(0x6310, output, type, 2), "");
        EXPECT_EQ(write(0x7300, output, value, 2), "");
        pass(10);
    }
};

}  // namespace

TEST_F(Ax130751Accuracy, OutputVoltageErrsByAtMostTwoThousandthsOfItsRange) {
    verifies<req::AOR_SPEC_001, req::AOR_S_VOLTAGE>();
    const double tolerance = 20.0 * 0.002;  // in V: 0.2 % of the range -10 V to 10 V
    for (const int millivolts : {0, 1, 2500, 4999, 5000}) {
        for (int output = 1; output <= 2; ++output) {
            command(output, 10, millivolts);
            EXPECT_NEAR(device->outputs().out_voltage[static_cast<std::size_t>(output - 1)], millivolts / 1000.0,
                        tolerance);
        }
    }
}

TEST_F(Ax130751Accuracy, OutputCurrentErrsByAtMostTwoThousandthsOfItsRange) {
    verifies<req::AOR_SPEC_001, req::AOR_S_CURRENT>();
    const double tolerance = 24.0 * 0.002;  // in mA: 0.2 % of the range 0 to 24 mA
    for (const int microamperes : {0, 4000, 12345, 20000}) {
        command(1, 20, microamperes);
        EXPECT_NEAR(device->outputs().out_current[0], microamperes / 1000.0, tolerance);
    }
}

TEST_F(Ax130751Accuracy, DutyCycleAndFrequencyErrByAtMostOneThousandthOfTheirRange) {
    verifies<req::AOR_S_DUTY, req::AOR_S_FREQUENCY, req::AOR_SPEC_002>();
    for (const int tenths : {1, 333, 1000}) {
        command(1, 40, tenths);
        EXPECT_NEAR(device->outputs().out_duty[0], tenths / 10.0, 100.0 * 0.001);
    }
    for (const int hertz : {50, 12345, 30000}) {
        command(2, 500, hertz);
        EXPECT_NEAR(device->outputs().out_frequency[1], hertz, 30000.0 * 0.001);
    }
}

}  // namespace canproof::test
