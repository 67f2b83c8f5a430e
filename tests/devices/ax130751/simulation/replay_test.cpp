// SPDX-License-Identifier: Apache-2.0
// Replays a recorded bus on the AX130751: the LSS session of section 3.1.3 of the manual, and an RPDO after it.
#include "host/sim/replay/replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "devices/catalogue.hpp"
#include "generated/ax130751/requirements.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Played {
    std::string frames;
    std::string outputs;
};

Played play(const std::string& log, const std::string& stimuli, std::uint64_t until_ms,
            const std::string& name = "ax130751") {
    const auto device = host::make_device(name);
    device->set_node_id(80);
    std::istringstream log_in{log};
    std::istringstream stimuli_in{stimuli};
    host::ReplayInput input;
    input.frames = host::read_candump_log(log_in, "log");
    input.stimuli = host::read_stimuli(stimuli_in, "stimuli");
    input.until = Instant{until_ms * 1000};
    std::ostringstream frames;
    std::ostringstream outputs;
    host::replay(*device, input, frames, &outputs);
    return {frames.str(), outputs.str()};
}

}  // namespace

// Frames 95 to 102 of the capture in the manual, whose time 11:42:40 is the power-on. Node 80 (50h) changes from 125 to
// 250 kbit/s.
TEST(Ax130751Replay, LssSessionOfTheManualGivesTheCapturedFrames) {
    verifies<req::AOR_LSS_001, req::AOR_LSS_003, req::AOR_T22>();
    const std::string log =
        "(5.248000) can0 7E5#0401\n"
        "(14.468000) can0 7E5#130003\n"
        "(18.687000) can0 7E5#158813\n"
        "(36.579000) can0 7E5#17\n"
        "(43.017000) can0 7E5#0400\n";
    EXPECT_EQ(play(log, "", 50000).frames,
              "(0.000000) can0 750#00\n"
              "(14.468000) can0 7E4#130000\n"
              "(36.579000) can0 7E4#170000\n"
              "(43.017000) can0 750#00\n");
}

// By default the ramp from 0 to 5 V takes 1000 ms: output 1 reaches 1 V after 200 ms, output 2 reaches 2 V after
// 400 ms. At 2 s the supply falls to 7.5 V, a fault.
TEST(Ax130751Replay, OutputsFollowAnRpdoAndTheSupply) {
    verifies<req::AOR_PDO_001, req::AOR_PDO_004, req::AOR_OUT_012, req::AOR_DIAG_006, req::AOR_DIAG_007,
             req::AOR_DIAG_012, req::AOR_S_SUPPLY, req::AOR_S_VOLTAGE, req::AOR_S_RELAY_NC, req::AOR_S_RELAY_NO>();
    const std::string log =
        "(1.000000) can0 000#0150\n"
        "(1.000000) can0 250#E803D00701\n";
    const Played played = play(log, "2.0,supply,7.5\n", 2050);
    using testing::HasSubstr;
    EXPECT_THAT(played.frames, HasSubstr("(1.500000) can0 1D0#E803D007\n"));  // 1000 and 2000 mV
    EXPECT_THAT(played.frames, HasSubstr(" can0 0D0#0031010000000000\n"));    // error code 3100h: supply fault
    EXPECT_THAT(played.outputs, HasSubstr("out1_voltage,1\n"));
    EXPECT_THAT(played.outputs, HasSubstr("out2_voltage,2\n"));
    EXPECT_THAT(played.outputs, HasSubstr("relay_nc,1\n"));
    EXPECT_THAT(played.outputs.substr(played.outputs.find("\n2.00")), HasSubstr("out1_voltage,0\n"));
    EXPECT_THAT(played.outputs.substr(played.outputs.find("\n2.00")), HasSubstr("relay_nc,0\n"));
}

// The part number AX130771 differs in housing and isolation only; on the bus it behaves like the AX130751.
TEST(Ax130751Replay, Ax130771AnswersLikeTheAx130751) {
    verifies<req::AOR_ID_001>();
    const std::string log =
        "(0.500000) can0 000#0150\n(0.600000) can0 650#4018100200000000\n(0.700000) can0 250#E803D00701\n";
    const Played one = play(log, "", 1500);
    const Played other = play(log, "", 1500, "ax130771");
    EXPECT_THAT(other.frames, testing::HasSubstr("5D0#43181002510713AA\n"));  // AA130751h
    EXPECT_EQ(one.frames, other.frames);
    EXPECT_EQ(one.outputs, other.outputs);
}

TEST(Ax130751Replay, TwoReplaysOfTheSameInputsGiveTheSameFramesAndOutputs) {
    verifies<req::AOR_PDO_004>();
    const std::string log = "(0.500000) can0 000#0150\n(0.700000) can0 250#E803D00701\n";
    const Played once = play(log, "0.9,load1,100\n", 1500);
    const Played again = play(log, "0.9,load1,100\n", 1500);
    EXPECT_EQ(once.frames, again.frames);
    EXPECT_EQ(once.outputs, again.outputs);
    EXPECT_FALSE(once.frames.empty());
}

}  // namespace canproof::test
