// SPDX-License-Identifier: Apache-2.0
// Tests the timers of an AX060805 with each event that can end, keep, force or restart them. They time the next sample
// of the sensor (manual, 5.1.2), the samples and blocks of the additional filters (manual, 4.3.10 to 4.3.12), and the
// time-out of the RPDO of a received value (manual, 3.10.1, 4.2.15). Node 127; the input filter is off, and all
// parameters are stored.
#include <functional>
#include <utility>

#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// A time in ms, and the value that the device gives from then on.
using Shown = std::vector<std::pair<int, int>>;

class Ax060805PendingTimers : public testing::Test, public InclinometerBench {
  protected:
    static constexpr int filter_rate = 40;

    struct Case {
        std::string name;
        std::function<void()> happens;
        Shown shown;  ///< the values that the device gives after the event
    };

    /// Starts a new unit at time 0. Its pitch is read in hundredths of a degree and passes an additional filter of type
    /// `filter` with `constant`. This filter takes a sample at 2 ms and then every 40 ms: at 42, 82, 122 ms. The sensor
    /// is sampled at multiples of 5 ms.
    void begin(std::uint32_t filter, std::uint32_t constant) {
        memory.bytes().assign(4096, 0xFF);
        inputs = ax060805::Inputs{};
        node = 127;
        now = Instant{};
        power_on();
        switch_filter_off();
        angle_digits(100);
        write(0x2050, 1, filter, 1);
        write(0x2051, 1, constant, 2);
        pass(2);
        write(0x2052, 0, filter_rate, 2);
        write(0x1010, 1, 0x65766173, 4);
    }
    /// Returns the pitch when `index` is 4030h, or the output of function 1 when `index` is 3000h.
    int shown(std::uint16_t index) const {
        return static_cast<std::int16_t>(device->objects().read(index, index == 0x3000 ? 1 : 0));
    }
    int time_ms() const { return static_cast<int>(now.us / 1000); }
    /// Returns each new value of object `index` until `end_ms`, with the time at which it appears.
    Shown watch(std::uint16_t index, int before, int end_ms) {
        Shown all;
        int last = before;
        while (true) {
            if (shown(index) != last) {
                last = shown(index);
                all.emplace_back(time_ms(), last);
            }
            if (time_ms() >= end_ms) {
                return all;
            }
            pass(1);
        }
    }
    /// Sets the pitch to 20 degrees at 3 ms. At `event_ms` performs the event of the case and then sets the pitch to 60
    /// degrees.
    void expect(const Case& one, int event_ms, int before, int end_ms) {
        pass(1);
        turn(20.0, 0.0);
        pass(static_cast<std::uint64_t>(event_ms - 3));
        EXPECT_EQ(shown(0x4030), before) << one.name;
        one.happens();
        turn(60.0, 0.0);
        EXPECT_EQ(watch(0x4030, before, end_ms), one.shown) << one.name;
    }
    void fail(bool fails) {
        inputs.accelerometer_fault = fails;
        set_inputs();
    }
};

}  // namespace

// Here the additional filter is off, so the pitch is that of the latest sample of the sensor.
TEST_F(Ax060805PendingTimers, EachNmtCommandSdoWriteAndFaultKeepsOrRestartsTheSensorSamplePeriod) {
    verifies<req::INC_FILTER_001, req::INC_AVG_004>();
    const Shown kept{{25, 6000}};
    const Shown renewed{{28, 6000}};  // the event at 23 ms restarts the samples: the next one is at 28 ms
    const std::vector<Case> cases{
        {"nothing happens", [] {}, kept},
        {"a new rate of the filters", [&] { write(0x2052, 0, 3, 2); }, kept},
        {"a new filter constant", [&] { write(0x2051, 1, 9, 2); }, kept},
        {"a new filter type of another angle", [&] { write(0x2050, 2, 1, 1); }, kept},
        {"a new cut-off frequency", [&] { write(0x2003, 0, 9, 1); }, kept},
        {"Euler angles", [&] { write(0x2100, 0, 0, 1); }, kept},
        {"a new operation of a function", [&] { write(0x300A, 1, 1, 1); }, kept},
        {"start", [&] { send("000#017F"); }, kept},
        {"stop", [&] { send("000#027F"); }, kept},
        {"the accelerometer fails and works again",
         [&] {
             fail(true);
             fail(false);
         },
         kept},
        {"the accelerometer fails until 31 ms",
         [&] {
             fail(true);
             pass(8);
             fail(false);
         },
         {{35, 6000}}},
        {"the accelerometer fails", [&] { fail(true); }, {}},
        {"reset communication", [&] { send("000#827F"); }, kept},
        {"reset node", [&] { send("000#817F"); }, renewed},
        {"power-on", [&] { power_on(); }, renewed},
    };
    for (const Case& one : cases) {
        begin(0, 1);
        expect(one, 23, 2000, 60);
    }
}

// The filter is a moving average of two samples: at first 0 degrees alone, then 0 and 60, then 60 and 60.
TEST_F(Ax060805PendingTimers, EachNmtCommandSdoWriteAndFaultKeepsOrRestartsTheFilterSamplePeriod) {
    verifies<req::INC_AVG_004, req::INC_AVG_005, req::INC_AVG_012, req::INC_AVG_013, req::INC_INSTALL_008>();
    const Shown kept{{42, 3000}, {82, 6000}};
    // the filter restarts with 20 degrees at the event, at 20 ms
    const Shown renewed{{20, 2000}, {60, 4000}, {100, 6000}};
    const std::vector<Case> cases{
        {"nothing happens", [] {}, kept},
        {"the same rate", [&] { write(0x2052, 0, filter_rate, 2); }, renewed},
        {"a shorter rate", [&] { write(0x2052, 0, 10, 2); }, {{20, 2000}, {30, 4000}, {40, 6000}}},
        {"a rate of 1000 ms", [&] { write(0x2052, 0, 1000, 2); }, {{20, 2000}}},
        {"the same constant: its samples alone are gone",
         [&] { write(0x2051, 1, 2, 2); },
         {{20, 2000}, {42, 4000}, {82, 6000}}},
        {"a constant of 3", [&] { write(0x2051, 1, 3, 2); }, {{20, 2000}, {42, 4000}, {82, 4667}, {122, 6000}}},
        {"the same type", [&] { write(0x2050, 1, 1, 1); }, {{20, 2000}, {42, 4000}, {82, 6000}}},
        {"no filter", [&] { write(0x2050, 1, 0, 1); }, {{20, 2000}, {25, 6000}}},
        {"the constant of another angle", [&] { write(0x2051, 2, 3, 2); }, kept},
        {"the type of another angle", [&] { write(0x2050, 3, 2, 1); }, kept},
        {"a new cut-off frequency", [&] { write(0x2003, 0, 9, 1); }, kept},
        {"Euler angles", [&] { write(0x2100, 0, 0, 1); }, renewed},
        {"an initial pitch of 5", [&] { write_real(0x2200, 0, 5.0F); }, {{20, 1500}, {60, 3500}, {100, 5500}}},
        {"Auto-Null", [&] { write(0x2300, 0, 1, 1); }, {{60, 2000}, {100, 4000}}},
        {"Auto-Null not commanded", [&] { write(0x2300, 0, 0, 1); }, kept},
        {"other digits of another angle", [&] { write(0x2030, 2, 10, 2); }, kept},
        {"the accelerometer fails between two samples",
         [&] {
             pass(1);
             fail(true);
             pass(2);
             fail(false);
         },
         kept},
        {"the accelerometer fails for one sample",
         [&] {
             fail(true);
             pass(11);
             fail(false);
         },
         {{35, 6000}}},
        {"the accelerometer fails", [&] { fail(true); }, {}},
        {"start", [&] { send("000#017F"); }, kept},
        {"stop", [&] { send("000#027F"); }, kept},
        {"reset communication", [&] { send("000#827F"); }, kept},
        {"reset node", [&] { send("000#817F"); }, renewed},
        {"power-on", [&] { power_on(); }, renewed},
    };
    for (const Case& one : cases) {
        begin(1, 2);
        expect(one, 20, 0, 140);
    }
}

// The filter is a repeating filter with blocks of three samples. In the first block it gives the mean of the samples so
// far, then the mean of each complete block.
TEST_F(Ax060805PendingTimers, BlockMeanRestartsOnlyAtAResetAWriteOrAFault) {
    verifies<req::INC_AVG_003, req::INC_AVG_011, req::INC_AVG_004, req::INC_AVG_012, req::INC_AVG_013>();
    const Shown kept{{42, 3000}, {82, 4000}, {202, 6000}};                  // blocks of 0 60 60, then 60 60 60
    const Shown renewed{{20, 2000}, {60, 4000}, {100, 4667}, {220, 6000}};  // blocks of 20 60 60
    const Shown begun_again{{20, 2000}, {42, 4000}, {82, 4667}, {202, 6000}};
    const std::vector<Case> cases{
        {"nothing happens", [] {}, kept},
        {"the same constant", [&] { write(0x2051, 1, 3, 2); }, begun_again},
        {"the same type", [&] { write(0x2050, 1, 2, 1); }, begun_again},
        {"a constant of 1", [&] { write(0x2051, 1, 1, 2); }, {{20, 2000}, {42, 6000}}},
        {"a moving average of 3", [&] { write(0x2050, 1, 1, 1); }, {{20, 2000}, {42, 4000}, {82, 4667}, {122, 6000}}},
        {"the same rate", [&] { write(0x2052, 0, filter_rate, 2); }, renewed},
        {"the constant of another angle", [&] { write(0x2051, 3, 9, 2); }, kept},
        {"the accelerometer fails for one sample",
         [&] {
             fail(true);
             pass(11);
             fail(false);
         },
         {{35, 6000}}},
        {"stop", [&] { send("000#027F"); }, kept},
        {"reset communication", [&] { send("000#827F"); }, kept},
        {"reset node", [&] { send("000#817F"); }, renewed},
    };
    for (const Case& one : cases) {
        begin(2, 3);
        expect(one, 20, 0, 230);
    }
}

// Function 1 gives the value that RPDO1 set at 2 ms. 100 ms later RPDO1 is late, which the next sample, at 105 ms,
// detects.
TEST_F(Ax060805PendingTimers, EachFrameSdoWriteAndFaultKeepsOrInvalidatesAReceivedValue) {
    verifies<req::INC_RPDO_002, req::INC_RPDO_003, req::INC_SIG_002, req::CO_PDO_021>();
    const Shown late{{105, 0}};
    const std::vector<Case> cases{
        {"nothing happens", [] {}, late},
        {"the same value again", [&] { send("27F#E80300000000"); }, {{155, 0}}},
        {"another value", [&] { send("27F#D00700000000"); }, {{55, 2000}, {155, 0}}},
        {"an RPDO that is too short", [&] { send("27F#D007"); }, late},
        {"a value by SDO", [&] { write(0x2500, 1, 2000, 2); }, {{55, 2000}, {105, 0}}},
        {"another one of the values by SDO", [&] { write(0x2500, 2, 2000, 2); }, late},
        {"a longer time, from the next one on", [&] { write(0x1400, 5, 200, 2); }, {}},
        {"no time", [&] { write(0x1400, 5, 0, 2); }, {}},
        {"pre-operational", [&] { send("000#807F"); }, {}},
        {"stop", [&] { send("000#027F"); }, {}},
        {"start", [&] { send("000#017F"); }, late},
        {"the accelerometer fails: pre-operational by 1029h:2", [&] { fail(true); }, {}},
        {"the accelerometer fails, 1029h:2 is 1",
         [&] {
             write(0x1029, 2, 1, 1);
             fail(true);
         },
         late},
        {"reset communication: no RPDO is awaited", [&] { send("000#827F"); }, {}},
        {"reset node", [&] { send("000#817F"); }, {{52, 0}}},
        {"power-on", [&] { power_on(); }, {{52, 0}}},
    };
    for (const Case& one : cases) {
        begin(0, 1);
        write(0x300A, 1, 1, 1);  // operation 1 adds
        write(0x3010, 1, 20, 1);
        write(0x3010, 2, 25, 1);  // 0
        write(0x1400, 5, 100, 2);
        write(0x1029, 1, 1, 1);  // 1029h:1 error behaviour: the node stays operational
        write(0x1010, 1, 0x65766173, 4);
        send("000#017F");
        send("27F#E80300000000");  // 3E8h = 1000
        pass(50);
        EXPECT_EQ(shown(0x3000), 1000) << one.name;
        one.happens();
        EXPECT_EQ(watch(0x3000, 1000, 300), one.shown) << one.name;
    }
}

}  // namespace canproof::test
