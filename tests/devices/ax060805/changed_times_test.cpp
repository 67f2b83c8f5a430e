// SPDX-License-Identifier: Apache-2.0
// Inverts a bit of the times that an AX060805 keeps in RAM. The device goes on to measure (node 127).
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/changed_time.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805ChangedTimes : public InclinometerTest {
  protected:
    /// The sensor is sampled at multiples of 5 ms. The additional filters take a value at 2 ms and then every 40 ms.
    void SetUp() override {
        InclinometerTest::SetUp();
        switch_filter_off();
        angle_digits(100);
        pass(2);
        write(0x2052, 0, 40, 2);  // 2052h (Angular Filter Rate)
    }
};

}  // namespace

TEST_F(Ax060805ChangedTimes, SensorIsSampledAtOnceWhenABitOfTheNextSampleTimeHasFlipped) {
    verifies<req::INC_FILTER_009>();
    pass(51);
    turn(60.0, 0.0);
    EXPECT_EQ(pitch(), 0) << "the next sample is that of 55 ms";
    ASSERT_EQ(move_far_ahead(*device, Instant{55'000}), 1U);
    set_inputs();
    EXPECT_EQ(pitch(), 6000);
    turn(30.0, 0.0);
    pass(5);
    EXPECT_EQ(pitch(), 3000) << "the sample 5 ms later";
}

TEST_F(Ax060805ChangedTimes, FiltersTakeAValueAtOnceWhenABitOfTheirNextTimeHasFlipped) {
    verifies<req::INC_AVG_019>();
    write(0x2050, 1, 1, 1);  // 2050h:1 (Angular Filter Type): moving average,
    write(0x2051, 1, 1, 2);  // 2051h:1 (Angular Filter Constant): of one sample
    pass(41);
    turn(60.0, 0.0);
    pass(20);
    EXPECT_EQ(pitch(), 0) << "the filter has taken a value at 42 ms; the next one is that of 82 ms";
    ASSERT_EQ(move_far_ahead(*device, Instant{82'000}), 1U);
    set_inputs();
    EXPECT_EQ(pitch(), 6000);
    turn(30.0, 0.0);
    pass(39);
    EXPECT_EQ(pitch(), 6000);
    pass(1);
    EXPECT_EQ(pitch(), 3000) << "the value 40 ms later, at 103 ms";
}

}  // namespace canproof::test
