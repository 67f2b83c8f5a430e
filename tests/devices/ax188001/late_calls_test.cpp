// SPDX-License-Identifier: Apache-2.0
// Tests an AX188001 whose advance() is called late: the device must perform each missed reading as if at the time when
// it was due.
#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001LateCalls : public TcsTest {
  protected:
    /// Lets time pass without a call of the device, then advances the device and returns its frames.
    Frames come_late(std::uint64_t ms) {
        now = now + milliseconds(ms);
        device->advance(now);
        return sent();
    }
    std::uint64_t next_in_ms() const { return elapsed(now, device->next_deadline()).us / 1000; }
};

}  // namespace

TEST_F(Ax188001LateCalls, FaultDelayRunsFromTheTimeAtWhichALateReadingWasDue) {
    verifies<req::TCS_LIM_003, req::TCS_IN_015>();
    write(0x4030, 1, 2, 1000);
    heat(1, 130.0);
    EXPECT_EQ(come_late(600), Frames{});  // the three readings at 165, 330 and 495 ms are missed and performed now
    EXPECT_EQ(pass(564), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#11F0010110000000"}));  // at 165 + 1000 ms
}

TEST_F(Ax188001LateCalls, FaultsWhoseDelaysEndBeforeALateReadingAreAllReported) {
    verifies<req::TCS_LIM_003, req::TCS_ERR_002>();
    write(0x4030, 1, 2, 100);
    write(0x4030, 2, 2, 120);
    heat(1, 130.0);
    heat(2, 130.0);
    EXPECT_EQ(pass(200), Frames{});  // both faults are read at 165 ms; their delays end at 265 and 285 ms
    heat(1, 20.0);
    heat(2, 20.0);
    // the reading at 330 ms ends both faults
    EXPECT_EQ(come_late(140),
              (Frames{"0FF#11F0010110000000", "0FF#11F0010210000000", "0FF#0000010000000000", "0FF#0000000000000000"}));
}

TEST_F(Ax188001LateCalls, FaultsOfTheUnitWhoseDelaysEndBeforeALateReadingAreAllReported) {
    verifies<req::TCS_FD_004, req::TCS_ERR_002>();
    write(0x5051, 1, 2, 100);
    write(0x5051, 2, 2, 120);
    inputs.cpu_temperature = 120.0F;
    inputs.supply = 55.0F;
    set_inputs();
    EXPECT_EQ(pass(200), Frames{});
    inputs = ax188001::Inputs{};
    set_inputs();
    EXPECT_EQ(come_late(140),
              (Frames{"0FF#0042010110000000", "0FF#0031010210000000", "0FF#0000010000000000", "0FF#0000000000000000"}));
}

TEST_F(Ax188001LateCalls, FaultThatEndsBeforeItsDelayIsNotReported) {
    verifies<req::TCS_LIM_012>();
    write(0x4030, 1, 2, 400);
    heat(1, 130.0);  // the fault is read at 165 ms; its delay ends at 565 ms
    pass(400);
    heat(1, 20.0);
    EXPECT_EQ(come_late(200), Frames{});  // the reading at 495 ms shows that the fault has ended
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{}));
}

TEST_F(Ax188001LateCalls, ReadingThatIsDueBeforeAFrameIsTakenFirst) {
    verifies<req::TCS_IN_015>();
    heat(1, 100.0);
    now = now + milliseconds(200);  // the device was not called since 0 ms
    EXPECT_EQ(process_value(1), 100 * 16 + 4368);
}

TEST_F(Ax188001LateCalls, ReadingThatIsDueUsesTheInputsBeforeTheirChange) {
    verifies<req::TCS_IN_001>();
    heat(1, 100.0);
    now = now + milliseconds(200);  // the device was not called since 0 ms; a reading was due at 165 ms
    heat(1, 50.0);
    EXPECT_EQ(process_value(1), 100 * 16 + 4368);
    pass(129);
    EXPECT_EQ(process_value(1), 100 * 16 + 4368);
    pass(1);  // 330: the next reading
    EXPECT_EQ(process_value(1), 50 * 16 + 4368);
}

TEST_F(Ax188001LateCalls, ReadingsStayOnTheirScheduleUnlessTooManyWereMissed) {
    verifies<req::TCS_IN_015, req::TCS_K_UPDATE_PERIOD>();
    come_late(600);
    EXPECT_EQ(next_in_ms(), 60U);  // the fourth reading, 4 * 165 = 660 ms, is next
    come_late(7 * 165);            // now 1755 ms: the seven readings from 660 to 1650 ms were missed
    EXPECT_EQ(next_in_ms(), 60U);  // the eleventh reading, 11 * 165 = 1815 ms, is next
    // more readings were missed than one call makes up for, so the schedule starts again at this call
    come_late(20 * 165);
    EXPECT_EQ(next_in_ms(), 165U);
}

TEST_F(Ax188001LateCalls, EightMissedReadingsAreAllMadeUpFor) {
    verifies<req::TCS_IN_015>();
    come_late(1400);               // the eight readings from 165 to 1320 ms were missed
    EXPECT_EQ(next_in_ms(), 85U);  // the ninth reading, 9 * 165 = 1485 ms, is next
}

}  // namespace canproof::test
