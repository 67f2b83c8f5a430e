// SPDX-License-Identifier: Apache-2.0
// The AX060805 measures temperatures and supply voltage only together with the acceleration. A parameter write between
// two of these samples must not update the measured values.
#include <cmath>
#include <limits>
#include <vector>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// One sample has been taken with the sensor at -20 °C, a supply of 12 V and the processor at 40 °C. 1 ms later, these
/// inputs change to 126 °C, 24 V and 80 °C.
class Ax060805MeasuredValues : public InclinometerTest {
  protected:
    void SetUp() override {
        InclinometerTest::SetUp();
        put(-20.0F, 12.0F, 40.0F);
        pass(5);
        put(126.0F, 24.0F, 80.0F);
        pass(1);
    }
    void put(float sensor_temperature, float supply, float processor_temperature) {
        inputs.sensor_temperature = sensor_temperature;
        inputs.supply_voltage = supply;
        inputs.processor_temperature = processor_temperature;
        set_inputs();
    }
    /// Returns 4060h (sensor temperature), 5020h (supply), 5030h (processor temperature) and 4020h (figure of merit).
    std::vector<float> shown() {
        return {static_cast<float>(value(0x4060)), real(0x5020), real(0x5030), static_cast<float>(read(0x4020))};
    }
};

}  // namespace

TEST_F(Ax060805MeasuredValues, ParameterWriteBetweenTwoSamplesDoesNotUpdateMeasuredValues) {
    verifies<req::INC_FV_012>();
    struct Write {
        std::uint16_t index;
        std::uint8_t sub;
        std::uint32_t value;
        int bytes;
    };
    // Each of these parameters changes how the device computes its values from a sample, so the device computes all
    // values again.
    const std::vector<Write> writes{{0x2002, 0, 0, 1},  {0x2003, 0, 50, 1}, {0x2011, 1, 1, 1}, {0x2031, 1, 1, 1},
                                    {0x2010, 1, 10, 2}, {0x2030, 1, 10, 2}, {0x2050, 1, 0, 1}, {0x2052, 0, 20, 2},
                                    {0x2100, 0, 0, 1},  {0x4080, 0, 7, 4},  {0x5555, 0, 1, 1}};
    const std::vector<float> last_sample{-20.0F, 12.0F, 40.0F, 0.0F};
    for (const auto& one : writes) {
        write(one.index, one.sub, one.value, one.bytes);
        EXPECT_EQ(shown(), last_sample) << one.index;
    }
    EXPECT_EQ(read(0x1001), 0U);  // the error register shows no error yet, like the figure of merit
    pass(4);
    EXPECT_EQ(shown(), (std::vector<float>{126.0F, 24.0F, 80.0F, 1.0F}));  // 126 °C is above the limit of 125 °C
    EXPECT_NE(read(0x1001), 0U);
}

TEST_F(Ax060805MeasuredValues, MeasuredValuesAfterResetCommunicationAreThoseOfTheLastSample) {
    verifies<req::INC_FV_012>();
    EXPECT_EQ(send("000#8200"), (Frames{"77F#00"}));
    EXPECT_EQ(shown(), (std::vector<float>{-20.0F, 12.0F, 40.0F, 0.0F}));
    EXPECT_EQ(read(0x1001), 0U);
    pass(4);
    EXPECT_EQ(shown(), (std::vector<float>{126.0F, 24.0F, 80.0F, 1.0F}));
    EXPECT_NE(read(0x1001), 0U);
}

TEST_F(Ax060805MeasuredValues, MeasuredValuesAre0AfterResetNodeUntilTheFirstValidMeasurement) {
    verifies<req::INC_FV_010, req::INC_GLOBAL_004, req::INC_GLOBAL_005>();
    put(NAN, 70.5F, 150.5F);
    send("000#8100");
    pass(10);
    EXPECT_EQ(shown(), (std::vector<float>{0.0F, 0.0F, 0.0F, 1.0F}));
}

TEST_F(Ax060805MeasuredValues, LeastSensorTemperatureAbove0IsRoundedTo0) {
    verifies<req::INC_FV_006>();
    put(std::numeric_limits<float>::denorm_min(), 24.0F, 80.0F);
    pass(4);
    EXPECT_EQ(value(0x4060), 0);
    put(-0.75F, 24.0F, 80.0F);
    pass(5);
    EXPECT_EQ(value(0x4060), -1);
}

TEST_F(Ax060805MeasuredValues, ResetNodeTakesANewMeasurementAtOnce) {
    verifies<req::INC_FV_012>();
    put(-21.0F, 24.0F, 80.0F);
    send("000#8100");  // reset node
    EXPECT_EQ(shown(), (std::vector<float>{-21.0F, 24.0F, 80.0F, 0.0F}));
}

}  // namespace canproof::test
