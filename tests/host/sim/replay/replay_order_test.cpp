// SPDX-License-Identifier: Apache-2.0
// Events of the same time are replayed in the order of a run: due work, then stimuli, then frames.
#include <gtest/gtest.h>

#include <sstream>

#include "devices/catalogue.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/replay/replay.hpp"
#include "tests/host/sim/replay/recording_device.hpp"

namespace canproof::host {

namespace {

std::string replayed(const std::string& log, const std::string& stimuli) {
    const auto device = make_device("cbx-ao412");
    std::istringstream log_in{log};
    std::istringstream stimuli_in{stimuli};
    ReplayInput input;
    input.frames = read_candump_log(log_in, "log");
    input.stimuli = read_stimuli(stimuli_in, "stimuli");
    std::ostringstream frames;
    replay(*device, input, frames, nullptr);
    return frames.str();
}

}  // namespace

TEST(ReplayOrder, StimulusPrecedesTheFrameOfTheSameTime) {
    EXPECT_EQ(replayed("(0.020000) can0 603#4001100000000000\n", "0.020000,internal_fault,1\n"),
              "(0.000000) can0 703#00\n(0.020000) can0 083#1061010100000000\n"
              "(0.020000) can0 583#4F01100001000000\n");
}

TEST(ReplayOrder, DueWorkPrecedesTheStimulusOfTheSameTime) {
    // a heartbeat every 100 ms after its write at 0.05 s
    EXPECT_EQ(replayed("(0.050000) can0 603#2B17100064000000\n(0.160000) can0 080#\n", "0.150000,internal_fault,1\n"),
              "(0.000000) can0 703#00\n(0.050000) can0 583#6017100000000000\n(0.150000) can0 703#7F\n"
              "(0.150000) can0 083#1061010100000000\n");
}

TEST(ReplayOrder, AnswersAreWrittenInTheOrderOfTheLog_NotOfTheDevice) {
    // The device gives both answers at once; the log contains the second before the first.
    const std::string log =
        "(0.010000) can0 603#4000100000000000 R\n(0.010000) can0 603#4001100000000000 R\n"
        "(0.011000) can0 583#4F01100000000000 T\n(0.012000) can0 583#4300100091010800 T\n";
    EXPECT_EQ(replayed(log, ""),
              "(0.011000) can0 583#4F01100000000000\n(0.012000) can0 583#4300100091010800\n(0.000000) can0 703#00\n");
}

TEST(ReplayOrder, EachCallOfTheDeviceIsAnnouncedOnceBeforeTheCall) {
    test::RecordingDevice device{milliseconds(10)};
    std::istringstream log{"(0.005000) can0 080#\n(0.010000) can0 081#\n"};
    std::istringstream stimuli{"0.007000,one,1\n"};
    ReplayInput input;
    input.frames = read_candump_log(log, "log");
    input.stimuli = read_stimuli(stimuli, "stimuli");
    input.before_call = [&device] { device.told.push_back("call"); };
    std::ostringstream frames;
    replay(device, input, frames, nullptr);
    EXPECT_EQ(device.told, (std::vector<std::string>{"0.000000 on", "call", "0.005000 080#", "call", "0.007000 one=1",
                                                     "call", "0.010000 due", "call", "0.010000 081#"}));
}

}  // namespace canproof::host
