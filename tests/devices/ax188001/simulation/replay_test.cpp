// SPDX-License-Identifier: Apache-2.0
// Replays stimuli to an AX188001: a temperature ramp through all limits, with an open circuit. Each emergency message
// must come at its due time.
#include "host/sim/replay/replay.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "devices/catalogue.hpp"
#include "generated/ax188001/requirements.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

std::string replayed(const std::string& log, const std::string& stimuli, double until, std::string* outputs = nullptr) {
    const auto device = host::make_device("ax188001");
    std::istringstream log_in{log};
    std::istringstream stimuli_in{stimuli};
    host::ReplayInput input;
    input.frames = host::read_candump_log(log_in, "log");
    input.stimuli = host::read_stimuli(stimuli_in, "stimuli");
    input.until = Instant{static_cast<std::uint64_t>(until * 1e6)};
    std::ostringstream frames;
    std::ostringstream changes;
    host::replay(*device, input, frames, &changes);
    if (outputs != nullptr) {
        *outputs = changes.str();
    }
    return frames.str();
}

/// Returns stimuli for a ramp that begins at -32 degC. It rises by 10 degC per second from second 11 to 42, and falls
/// from second 58 to 88.
std::string ramp() {
    std::ostringstream csv;
    csv << "0,tc1_celsius,-32\n";
    for (int second = 11; second <= 42; ++second) {
        csv << second << ",tc1_celsius," << -32 + 10 * (second - 10) << '\n';
    }
    csv << "46,tc1_open,1\n55,tc1_open,0\n";
    for (int second = 58; second <= 88; ++second) {
        csv << second << ",tc1_celsius," << 288 - 10 * (second - 57) << '\n';
    }
    return csv.str();
}

}  // namespace

// Readings fall on multiples of 165 ms; a fault is reported 5000 ms after its first reading:
//   0.000  -32 degC at power-on, below -20                         reported at  5.000
//  12      -12 degC, first above -19; read at 73 * 0.165 = 12.045  clears at 12.045
//  26      128 degC, first above 125; read at 158 * 0.165 = 26.070 reported at 31.070
//  39      258 degC, first above 250; read at 237 * 0.165 = 39.105 reported at 44.105
//  46      wire breaks; read at 279 * 0.165 = 46.035, two gains of 660 ms each: open at 47.355, reported at 52.355
//  55      repaired; read at 334 * 0.165 = 55.110
//  61      248 degC, first below 249; read at 370 * 0.165 = 61.050
//  74      118 degC, first below 124; read at 449 * 0.165 = 74.085
//  88      -22 degC, first below -20; read at 534 * 0.165 = 88.110 reported at 93.110
TEST(Ax188001Replay, ReplayOfATemperatureRampAndABrokenWireGivesEachEmcyAtItsTime) {
    verifies<req::TCS_LIM_001, req::TCS_LIM_002, req::TCS_LIM_003, req::TCS_LIM_004, req::TCS_LIM_009, req::TCS_IN_006,
             req::TCS_ERR_001, req::TCS_ERR_002, req::TCS_ERR_013, req::TCS_S_CELSIUS, req::TCS_S_OPEN,
             req::TCS_LIM_016, req::TCS_LIM_017>();
    EXPECT_EQ(replayed("", ramp(), 95.0),
              "(0.000000) can0 77F#00\n"
              "(5.000000) can0 0FF#11F0010120000000\n"
              "(12.045000) can0 0FF#0000000000000000\n"
              "(31.070000) can0 0FF#11F0010110000000\n"
              "(44.105000) can0 0FF#11F0010140000000\n"
              "(52.355000) can0 0FF#01F0010100000000\n"
              "(55.110000) can0 0FF#0000010000000000\n"
              "(61.050000) can0 0FF#0000010000000000\n"
              "(74.085000) can0 0FF#0000000000000000\n"
              "(93.110000) can0 0FF#11F0010120000000\n");
}

TEST(Ax188001Replay, TwoReplaysGiveTheSameFramesAndOutputs) {
    verifies<req::TCS_IN_015>();
    std::string outputs[2];
    const std::string log = "(0.100000) can0 000#0100\n(7.000000) can0 67F#4000610100000000\n";
    EXPECT_EQ(replayed(log, ramp(), 95.0, &outputs[0]), replayed(log, ramp(), 95.0, &outputs[1]));
    EXPECT_EQ(outputs[0], outputs[1]);
}

// The process value of 100 degC is 5968 = 1750h, that of 25 degC is 4768 = 12A0h. Each TPDO carries the value of the
// last reading before it.
TEST(Ax188001Replay, ProcessValuesAreSentEverySecond) {
    verifies<req::TCS_PDO_001, req::TCS_S_CELSIUS>();
    EXPECT_EQ(replayed("(0.500000) can0 000#0100\n", "2.4,tc1_celsius,100\n", 3.6),
              "(0.000000) can0 77F#00\n"
              "(0.500000) can0 1FF#A012A012\n"
              "(1.500000) can0 1FF#A012A012\n"
              "(2.500000) can0 1FF#5017A012\n"
              "(3.500000) can0 1FF#5017A012\n");
}

// The simulated thermocouple wire has the type of 6110h (TC Sensor Type) until the stimulus tc1_wire names another
// type. A wire of type K at 100 degC has 4.096 mV, which is 78 degC for type J.
TEST(Ax188001Replay, ThermocoupleWireHasTheConfiguredTypeUnlessAStimulusNamesAnother) {
    verifies<req::TCS_S_WIRE, req::TCS_S_CELSIUS, req::TCS_S_MICROVOLTS>();
    const std::string read_pv = "(1.000000) can0 67F#4030710100000000\n(3.000000) can0 67F#4030710100000000\n";
    const std::string to_k = "(0.200000) can0 67F#2B10610102000000\n";
    // Without tc1_wire the wire is of type K like the channel, which reads 100 degC. Then a voltage of 0 uV without hum
    // gives 25 degC, the cold junction temperature.
    EXPECT_EQ(replayed(to_k + read_pv, "0.5,tc1_celsius,100\n2,tc1_microvolts,0\n", 3.1),
              "(0.000000) can0 77F#00\n"
              "(0.200000) can0 5FF#6010610100000000\n"
              "(1.000000) can0 5FF#4B30710150170000\n"
              "(3.000000) can0 5FF#4B307101A0120000\n");
    // A wire of type J at 100 degC on a channel set to type K gives 5.269 - 1.277 + 1.000 = 4.992 mV. For type K this
    // is 121.76 degC (4.920 mV at 120 degC, 40.8 uV/K).
    const std::string mixed = replayed(to_k + read_pv, "0,tc1_wire,1\n0.5,tc1_celsius,100\n", 3.1);
    EXPECT_NE(mixed.find("5FF#4B307101AC18"), std::string::npos) << mixed;  // 121.76 * 16 + 4368 = 6316 = 18ACh
}

TEST(Ax188001Replay, ReplayWritesTheGainsAndTheFilterAsOutputs) {
    verifies<req::TCS_S_ADC_FILTER, req::TCS_S_ADC_GAIN>();
    std::string outputs;
    replayed("(1.000000) can0 67F#2F20200032000000\n", "2,tc2_microvolts,30000\n", 4.0, &outputs);
    EXPECT_NE(outputs.find("0.000000,adc_filter,60\n"), std::string::npos) << outputs;
    EXPECT_NE(outputs.find("1.000000,adc_filter,50\n"), std::string::npos) << outputs;
    EXPECT_NE(outputs.find("2.145000,tc2_gain,64\n"), std::string::npos) << outputs;
}

}  // namespace canproof::test
