// SPDX-License-Identifier: Apache-2.0
// Gives an AX130751 the most work of a power-on and of a reset: two sound sets of parameters, of which the newer cannot
// be read to its end. When these tests run on the microcontroller, src/target/run_suites measures this work.
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/unreadable_set.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751StartLoad : public UnreadableSet<Ax130751Bench, 8192> {
  protected:
    void SetUp() override {
        power_cycle();
        EXPECT_EQ(write(0x1017, 0, 500, 2), "");  // 1017h (producer heartbeat time): 500 ms
        store_two_sets([this] { EXPECT_EQ(store(), Frames{"5FF#6010100100000000"}); });
    }
};

}  // namespace

TEST_F(Ax130751StartLoad, PowerOnWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::AOR_ERR_021>();
    const Frames frames = with_unreadable_value([this] { return power_cycle(); });
    EXPECT_EQ(frames, (Frames{"77F#00", "0FF#0063010000000000"})) << "damaged stored values";
    EXPECT_EQ(read(0x1017, 0), 0U);
    power_cycle();
    EXPECT_EQ(read(0x1017, 0), 500U);
}

TEST_F(Ax130751StartLoad, ResetWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::AOR_ERR_021>();
    const Frames frames = with_unreadable_value([this] { return send("000#817F"); });
    EXPECT_EQ(frames, (Frames{"77F#00", "0FF#0063010000000000"})) << "damaged stored values";
    EXPECT_EQ(read(0x1017, 0), 0U);
    send("000#817F");
    EXPECT_EQ(read(0x1017, 0), 500U);
}

}  // namespace canproof::test
