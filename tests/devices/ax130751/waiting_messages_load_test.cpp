// SPDX-License-Identifier: Apache-2.0
// Gives an AX130751 the most work for one NMT command: a start sends the beginning and the end of ten errors, and all
// TPDOs. When this test runs on the microcontroller, src/target/run_suites measures this frame.
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751WaitingMessagesLoad : public DisturbedBus<Ax130751Blocks> {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        set8(0x1029, 1, 1);  // 1029h:1 (error behaviour): no change of the NMT state
        check_values_of_rpdo2();
        send_all_tpdos_after(1000);
    }
    /// Makes the node watch four producers of heartbeats, its life guarding and RPDO1, for 100 ms each.
    void watch_others() {
        for (int slot = 1; slot <= 4; ++slot) {
            set32(0x1016, slot, ((10 + slot) * 0x10000) + 100);
        }
        set16(0x100C, 0, 100);
        set8(0x100D, 0, 1);
        set16(0x1400, 5, 100);
    }
    /// Ends the errors of the others, which cannot end again with the same frames.
    void hear_others() {
        for (const char* const frame : {"70B#05", "70C#05", "70D#05", "70E#05", "77F#R", "27F#E803E80300"}) {
            send_alone(frame);
        }
    }
    /// Begins and ends the errors of the supply voltage and the temperature.
    void fail(bool fails) {
        inputs.supply = fails ? 7.0F : 24.0F;
        inputs.cpu_temperature = fails ? 90.0F : 30.0F;
        set_inputs();
        pass(1);
    }
};

}  // namespace

TEST_F(Ax130751WaitingMessagesLoad, StartSendsTwoMessagesOfEachErrorAndAllTpdos) {
    verifies<req::CO_EMCY_004, req::CO_EMCY_006>();
    watch_others();
    hear_others();
    disturb_bus();
    fail(true);
    pass(150);
    hear_others();
    fail(false);
    for (const char* const frame : {"27F#00", "27F#E803E80300", "37F#FFFF", "37F#0100"}) {
        send_alone(frame);  // the errors of a length and of a value begin and end
    }
    send("000#027F");
    pass(1);
    free_bus(8);
    const Frames frames = send_alone("000#017F");
    EXPECT_EQ(frames.size(), 8U + 20U + 4U);
}

}  // namespace canproof::test
