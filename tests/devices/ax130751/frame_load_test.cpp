// SPDX-License-Identifier: Apache-2.0
// Gives an AX130751 the most work for one frame: four RPDOs with one COB-ID, which are late, or a start after a
// disturbance of the bus. When these tests run on the microcontroller, src/target/run_suites measures these frames.
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751FrameLoad : public DisturbedBus<Ax130751Blocks> {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        for (int number = 0; number < 4; ++number) {
            map_extra_values(0x1400 + number, 0x1600 + number, 0x4000027F);
            set16(static_cast<std::uint16_t>(0x1400 + number), 5, 50);
        }
    }
    /// Maps 2500h:1 to 2500h:4 (EC Extra Received Process Value) into a PDO, and makes it valid.
    void map_extra_values(int parameter, int mapping, std::int64_t cob_id) {
        const auto parameters = static_cast<std::uint16_t>(parameter);
        const auto lines = static_cast<std::uint16_t>(mapping);
        set32(parameters, 1, 0x80000000 | cob_id);
        set8(lines, 0, 0);
        for (int line = 1; line <= 4; ++line) {
            set32(lines, line, 0x25000010 + (0x100 * line));
        }
        set8(lines, 0, 4);
        set32(parameters, 1, cob_id);
    }
};

}  // namespace

TEST_F(Ax130751FrameLoad, FrameOfFourLateRpdosGivesFourValues) {
    verifies<req::CO_PDO_059, req::CO_PDO_067>();
    fail_controller(true);
    inputs.cpu_temperature = 90.0F;
    set_inputs();
    send("27F#0100010001000100");
    pass(600);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U) << "an RPDO is overdue";
    now = now + Duration{500};
    free_bus(26);
    const Frames frames = send_alone("27F#0200030004000500");
    EXPECT_EQ(get16(0x2500, 1), 2);
    EXPECT_EQ(get16(0x2500, 4), 5);
    EXPECT_EQ(frames.size(), 26U + 1U) << "the message that the error ends";
}

TEST_F(Ax130751FrameLoad, StartSendsAllMessagesThatWaitedInStopped) {
    verifies<req::CO_EMCY_004, req::CO_EMCY_006>();
    set32(0x1016, 1, 0x000B0000 + 100);  // 1016h:1 (consumer heartbeat time): node 11
    send("70B#05");
    send("27F#0100010001000100");
    pass(1);
    disturb_bus();
    for (const bool fails : {true, false, true, false}) {
        fail_controller(fails);
        inputs.supply = fails ? 7.0F : 24.0F;
        inputs.cpu_temperature = fails ? 90.0F : 30.0F;
        set_inputs();
        if (!fails) {
            send_alone("70B#05");
            send_alone("27F#0100010001000100");
        }
        pass(600);
    }
    send("000#027F");
    pass(1);
    free_bus(20);
    const Frames frames = send_alone("000#017F");
    EXPECT_GE(frames.size(), 20U + 6U);
}

}  // namespace canproof::test
