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
        EXPECT_EQ(write(0x1017, 0, 2, 500), 0U);  // 1017h (producer heartbeat time): 500 ms
        store_two_sets([this] { EXPECT_EQ(write(0x1010, 1, 4, save), 0U); });
        heat(1, 1190.0);
        heat(2, -205.0);
        inputs.supply = 8.0F;
        inputs.cpu_temperature = 120.0F;
        set_inputs();
    }
};

}  // namespace

TEST_F(Ax188001StartLoad, PowerOnWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::TCS_ERR_022>();
    const Frames frames = with_unreadable_value([this] { return power_cycle(); });
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#0063010000000000") << "damaged stored values";
    EXPECT_EQ(read(0x1017).value, 0U);
    power_cycle();
    EXPECT_EQ(read(0x1017).value, 500U);
}

TEST_F(Ax188001StartLoad, ResetWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::TCS_ERR_022>();
    const Frames frames = with_unreadable_value([this] { return send("000#817F"); });
    EXPECT_EQ(frames.front(), "77F#00");
    EXPECT_EQ(frames.at(1), "0FF#0063010000000000") << "damaged stored values";
    EXPECT_EQ(read(0x1017).value, 0U);
    send("000#817F");
    EXPECT_EQ(read(0x1017).value, 500U);
}

}  // namespace canproof::test
