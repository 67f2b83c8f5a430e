// SPDX-License-Identifier: Apache-2.0
// Tests each event that can end, keep or restart the delay before a fault of the AX188001 is reported (manual, 1.1,
// 1.4, 3.4.16, 3.4.21). 4030h (TC Error React Delay) and 5051h (FD Error Response Delay) set this delay. Readings are
// at multiples of 165 ms; the first one that shows the fault starts the delay.
#include <functional>

#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr int never_told = -1;
constexpr int event_at = 500;

class Ax188001PendingTimers : public TcsTest {
  protected:
    struct Case {
        std::string name;
        std::function<void()> happens;  ///< at 500 ms
        int told_at;                    ///< when the fault is reported, in ms after its start
    };

    /// Restarts the device with fault delays of one second.
    void begin() {
        memory.bytes().assign(1024, 0xFF);
        inputs = ax188001::Inputs{};
        now = Instant{};
        SetUp();
        for (int sub = 1; sub <= 2; ++sub) {
            ASSERT_EQ(write(0x4030, sub, 2, 1000), 0U);
            ASSERT_EQ(write(0x5051, sub, 2, 1000), 0U);
        }
    }
    /// Waits until the device sends `message`. Returns the time since `start` in milliseconds, or never_told if eight
    /// seconds pass without the message.
    int told(Instant start, const std::string& message) {
        for (int i = 0; i < 8000; ++i) {
            for (const std::string& frame : pass(1)) {
                if (frame == "1:" + message) {
                    return static_cast<int>(elapsed(start, now).us / 1000);
                }
            }
        }
        return never_told;
    }
    void expect(const Case& one, const std::string& message) {
        EXPECT_EQ(pass(event_at), Frames{}) << one.name;
        one.happens();
        const bool at_once = one.told_at == event_at;
        EXPECT_EQ(read(0x1003, 0).value, at_once ? 1U : 0U) << one.name;
        EXPECT_EQ(told(Instant{}, message), at_once ? never_told : one.told_at) << one.name;
    }
};

}  // namespace

TEST_F(Ax188001PendingTimers, EachCommandWriteAndInputChangeKeepsEndsOrRestartsAChannelLimitDelay) {
    verifies<req::TCS_LIM_003, req::TCS_LIM_012, req::TCS_LIM_006, req::TCS_LIM_013, req::TCS_LIM_010,
             req::TCS_LIM_014>();
    for (const int channel : {1, 2}) {
        const int other = 3 - channel;
        const std::vector<Case> cases{
            {"nothing happens", [] {}, 165 + 1000},
            {"it ends and comes again",
             [&] {
                 heat(channel, 20.0);
                 pass(200);  // the reading at 660 ms shows 20 degC
                 heat(channel, 130.0);
             },
             825 + 1000},
            {"it ends", [&] { heat(channel, 20.0); }, never_told},
            {"disabled and enabled again",
             [&] {
                 write(0x6112, channel, 1, 0);
                 write(0x6112, channel, 1, 1);
             },
             event_at + 1000},
            {"disabled", [&] { write(0x6112, channel, 1, 0); }, never_told},
            {"the other channel disabled", [&] { write(0x6112, other, 1, 0); }, 165 + 1000},
            {"a delay that is over", [&] { write(0x4030, channel, 2, 300); }, event_at},
            {"a shorter delay, over before the next reading", [&] { write(0x4030, channel, 2, 450); }, 165 + 450},
            {"a longer delay", [&] { write(0x4030, channel, 2, 2000); }, 165 + 2000},
            {"the other channel's delay", [&] { write(0x4030, other, 2, 100); }, 165 + 1000},
            {"the delay of the supply", [&] { write(0x5051, 2, 2, 100); }, 165 + 1000},
            {"the limit moves away and back",
             [&] {
                 write(0x4010, channel, 2, 1400);
                 write(0x4010, channel, 2, 1250);
             },
             event_at + 1000},
            {"the limit moves away", [&] { write(0x4010, channel, 2, 1400); }, never_told},
            {"the other limit", [&] { write(0x4000, channel, 2, 0xFED4); }, 165 + 1000},
            {"the other channel breaks", [&] { cut(other); }, 165 + 1000},
            {"reset communication", [&] { send("000#827F"); }, 165 + 1000},
            {"reset node: 5000 ms as shipped", [&] { send("000#817F"); }, event_at + 5000},
        };
        const std::string message = channel == 1 ? "0FF#11F0010110000000" : "0FF#11F0010210000000";
        for (const Case& one : cases) {
            begin();
            heat(channel, 130.0);
            expect(one, message);
        }
    }
}

TEST_F(Ax188001PendingTimers, EachCommandWriteAndInputChangeKeepsEndsOrRestartsASupplyFaultDelay) {
    verifies<req::TCS_FD_004, req::TCS_FD_013, req::TCS_FD_016>();
    const auto supply = [this](float volts) {
        inputs.supply = volts;
        set_inputs();
    };
    const std::vector<Case> cases{
        {"nothing happens", [] {}, 165 + 1000},
        {"it ends", [&] { supply(24.0F); }, never_told},
        {"it ends between the thresholds and comes again",
         [&] {
             supply(49.0F);  // 49 V is between the set threshold of 50 V and the clear threshold of 48 V
             pass(200);
             supply(55.0F);
         },
         825 + 1000},
        {"disabled", [&] { write(0x5050, 2, 1, 0); }, never_told},
        {"disabled and enabled again",
         [&] {
             write(0x5050, 2, 1, 0);
             write(0x5050, 2, 1, 1);
         },
         event_at + 1000},
        {"that of the temperature disabled", [&] { write(0x5050, 1, 1, 0); }, 165 + 1000},
        {"a delay that is over", [&] { write(0x5051, 2, 2, 300); }, event_at},
        {"a shorter delay, over before the next reading", [&] { write(0x5051, 2, 2, 450); }, 165 + 450},
        {"a longer delay", [&] { write(0x5051, 2, 2, 3000); }, 165 + 3000},
        {"that of the temperature", [&] { write(0x5051, 1, 2, 100); }, 165 + 1000},
        {"the threshold moves away", [&] { write(0x5041, 2, 2, 600); }, never_told},
        {"reset communication", [&] { send("000#827F"); }, 165 + 1000},
        {"reset node: 5000 ms as shipped", [&] { send("000#817F"); }, event_at + 5000},
    };
    for (const Case& one : cases) {
        begin();
        supply(55.0F);
        expect(one, "0FF#0031010210000000");
    }
}

TEST_F(Ax188001PendingTimers, EachCommandWriteAndInputChangeKeepsEndsOrRestartsAnOpenCircuitDelay) {
    verifies<req::TCS_LIM_003, req::TCS_LIM_012, req::TCS_LIM_006, req::TCS_LIM_013>();
    // The voltage is read at 165 ms, and the open circuit is detected at 165 + 1320 = 1485 ms.
    const std::vector<Case> cases{
        {"nothing happens", [] {}, 1485 + 1000},
        {"mended before it is known", [&] { cut(2, false); }, never_told},
        {"disabled before it is known, enabled",
         [&] {
             write(0x6112, 2, 1, 0);
             write(0x6112, 2, 1, 1);
         },
         1485 + 1000},
        {"reset communication", [&] { send("000#827F"); }, 1485 + 1000},
        {"reset node: known at once, 5000 ms as shipped", [&] { send("000#817F"); }, event_at + 5000},
    };
    for (const Case& one : cases) {
        begin();
        cut(2);
        expect(one, "0FF#01F0010200000000");
    }
}

// The reading at 165 ms shows the limit fault. The circuit breaks at 500 ms: the reading at 660 ms shows it, and it is
// known as open at 660 + 1320 = 1980 ms. The circuit is closed again at 2500 ms, which the reading at 2640 ms shows.
TEST_F(Ax188001PendingTimers, OpenCircuitDropsEachPendingLimitFault) {
    verifies<req::TCS_LIM_012, req::TCS_LIM_018>();
    struct Limit {
        double celsius;
        const char* message;  ///< emergency message of channel 1, for the most severe limit that is exceeded
    };
    for (const Limit& one : {Limit{130.0, "0FF#11F0010110000000"}, Limit{-30.0, "0FF#11F0010120000000"},
                             Limit{260.0, "0FF#11F0010140000000"}}) {
        begin();
        write(0x4030, 1, 2, 3000);
        heat(1, one.celsius);
        pass(500);
        cut(1);
        pass(2000);
        EXPECT_EQ(process_value(1), -512);
        cut(1, false);
        EXPECT_EQ(told(Instant{}, one.message), 2640 + 3000) << one.celsius;
    }
}

}  // namespace canproof::test
