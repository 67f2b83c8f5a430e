// SPDX-License-Identifier: Apache-2.0
// Gives an AX060805 the most work of a power-on and of a reset: two sound sets of parameters, of which the newer cannot
// be read to its end. When these tests run on the microcontroller, src/target/run_suites measures this work.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/unreadable_set.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805StartLoad : public UnreadableSet<InclinometerBench, 4096> {
  protected:
    void SetUp() override {
        power_cycle();
        turn(20.0, 10.0);
        write(0x1017, 0, 500, 2);  // 1017h (producer heartbeat time): 500 ms
        store_two_sets([this] { write(0x1010, 1, 0x65766173, 4); });
        inputs.sensor_temperature = 200.0F;
        inputs.can_overrun = true;
    }
};

}  // namespace

TEST_F(Ax060805StartLoad, PowerOnWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::INC_ERR_021>();
    const Frames frames = with_unreadable_value([this] { return power_cycle(); });
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#0063010000000000") << "damaged stored values";
    EXPECT_EQ(read(0x1017), 0U);
    power_cycle();
    EXPECT_EQ(read(0x1017), 500U);
}

TEST_F(Ax060805StartLoad, ResetWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::INC_ERR_021>();
    const Frames frames = with_unreadable_value([this] { return send("000#817F"); });
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#0063010000000000") << "damaged stored values";
    EXPECT_EQ(read(0x1017), 0U);
    send("000#817F");
    EXPECT_EQ(read(0x1017), 500U);
}

}  // namespace canproof::test
