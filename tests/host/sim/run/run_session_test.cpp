// SPDX-License-Identifier: Apache-2.0
// Runs devices on the in-process bus in virtual time. The log of a run must replay to the same frames. Stimuli, outputs
// and the table of a run are also tested.
#include "host/sim/run/run_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "host/base/input_error.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/replay/replay.hpp"
#include "host/sim/run/live_table.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

struct TestRun {
    explicit TestRun(const std::vector<std::string>& names, std::vector<Stimulus> stimuli = {},
                     const BusFaultRates& faults = {}) {
        std::vector<std::unique_ptr<DeviceNode>> nodes;
        for (const auto& name : names) {
            nodes.push_back(std::make_unique<DeviceNode>(name, choose_device(name).device));
        }
        SessionOutputs outputs;
        outputs.log = &log;
        outputs.log_format = LogFormat::marked;
        outputs.outputs = &changes;
        session = std::make_unique<RunSession>(std::make_unique<ArbitratedBus>("inproc", 125000, faults),
                                               std::move(nodes), std::move(stimuli), outputs);
        session->power_on();
    }
    /// Sends a frame from outside at that time.
    void put(std::uint64_t us, const std::string& frame) {
        session->advance_to(Instant{us});
        EXPECT_TRUE(session->put(parse_frame(frame, "test")));
    }

    std::ostringstream log;
    std::ostringstream changes;
    std::unique_ptr<RunSession> session;
};

/// Returns the frames of a log without their times: those whose line ends with `mark` (T or R), or all of them if
/// `mark` is empty.
std::vector<std::string> frames_of(const std::string& log, const std::string& mark) {
    std::istringstream lines{log};
    std::vector<std::string> frames;
    std::string time;
    std::string interface;
    std::string frame;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        std::string own;
        words >> time >> interface >> frame >> own;
        if (mark.empty() || own == mark) {
            frames.push_back(frame);
        }
    }
    return frames;
}

void converse(TestRun& run) {
    run.put(10000, "603#2B17100064000000");  // 1017h producer heartbeat time: 100 ms
    run.put(20000, "000#0103");
    run.put(30000, "603#2B116401B33E0000");
    run.put(40123, "603#4008100000000000");  // 1008h device name, in segments
    run.put(50000, "603#6000000000000000");
    run.put(60000, "603#7000000000000000");
    run.put(70000, "703#R");
    run.session->advance_to(Instant{1000000});
}

std::string replayed(const std::string& device, int node, const std::string& log, std::vector<Stimulus> stimuli = {}) {
    std::istringstream in{log};
    ReplayInput input;
    input.frames = read_candump_log(in, "log");
    input.stimuli = std::move(stimuli);
    const ChosenDevice chosen = choose_device(device);
    chosen.device->set_node_id(node);
    std::ostringstream out;
    replay(*chosen.device, input, out, nullptr);
    return out.str();
}

}  // namespace

TEST(RunSession, ReplayOfTheLogOfARunGivesTheSameFrames) {
    TestRun run{{"cbx-ao412@3"}};
    converse(run);
    const auto own = frames_of(run.log.str(), "T");
    EXPECT_GT(own.size(), 12U);  // boot-up, five answers, nine heartbeats
    EXPECT_EQ(frames_of(replayed("cbx-ao412", 3, run.log.str()), ""), own);
}

TEST(RunSession, LogOfSeveralDevicesCanBeReplayedForEachOfThem) {
    TestRun run{{"cbx-ao412@3", "cbx-ao412@4", "ax188001@20"}};
    run.put(5000, "604#2B17100032000000");
    converse(run);
    for (const auto& [device, node, error_control] :
         {std::tuple{"cbx-ao412", 3, "703#"}, std::tuple{"cbx-ao412", 4, "704#"}, std::tuple{"ax188001", 20, "714#"}}) {
        std::vector<std::string> expected;
        for (const auto& frame : frames_of(run.log.str(), "T")) {
            const unsigned id = parse_frame(frame, "log").id;
            if ((id & 0x7FU) == static_cast<unsigned>(node)) {
                expected.push_back(frame);
            }
        }
        const std::vector<std::string> again = frames_of(replayed(device, node, run.log.str()), "");
        // The last frames may still wait for the bus when the run ends.
        ASSERT_GE(again.size(), expected.size()) << device << "@" << node;
        EXPECT_TRUE(std::is_permutation(expected.begin(), expected.end(), again.begin())) << device << "@" << node;
        EXPECT_EQ(again.front().substr(0, 4), error_control);
    }
}

TEST(RunSession, LogLinesOfEachDeviceMatchItsReplay_OnABusyBus) {
    // Heartbeats every 5 ms and requests in quick succession: an answer (580h + node) overtakes a heartbeat (700h +
    // node) that waits for the bus. The replay of a log with T and R has the same order and the same times.
    TestRun run{{"cbx-ao412@3", "cbx-ao412@4", "ax188001@20"}};
    for (const char* node : {"603", "604", "614"}) {
        run.put(10000, node + std::string{"#2B17100005000000"});
    }
    for (std::uint64_t us = 20000; us < 500000; us += 9000) {
        run.put(us, "603#4000100000000000");
        run.put(us, "604#4000100000000000");
        run.put(us, "614#4000100000000000");
        run.put(us, "080#");
    }
    run.session->advance_to(Instant{1000000});
    bool overtaken = false;
    for (const auto& [device, node] :
         {std::pair{"cbx-ao412", 3}, std::pair{"cbx-ao412", 4}, std::pair{"ax188001", 20}}) {
        std::string own;
        std::istringstream lines{run.log.str()};
        for (std::string line; std::getline(lines, line);) {
            const LoggedFrame logged = parse_candump_line(line, "log");
            if (logged.mark == LogMark::transmitted && (logged.frame.id & 0x7FU) == static_cast<unsigned>(node)) {
                own += format_candump_line(logged) + "\n";
            }
        }
        const std::string again = replayed(device, node, run.log.str());
        EXPECT_EQ(again.substr(0, own.size()), own) << device << "@" << node;
        // Without T and R in the log, the replay writes the frames in the order of the device: the same frames, some in
        // another order.
        std::string plain = run.log.str();
        plain.erase(std::remove_if(plain.begin(), plain.end(), [](char one) { return one == 'T' || one == 'R'; }),
                    plain.end());
        const auto unmarked = frames_of(replayed(device, node, plain), "");
        const auto marked = frames_of(again, "");
        ASSERT_EQ(unmarked.size(), marked.size());
        EXPECT_TRUE(std::is_permutation(marked.begin(), marked.end(), unmarked.begin()));
        overtaken = overtaken || marked != unmarked;
    }
    EXPECT_TRUE(overtaken);
}

TEST(RunSession, OwnFramesOfADeviceAreNotConfusedWithThoseOfOthersInItsReplay) {
    // The device monitors the heartbeat of its own node-ID for 50 ms and sends it every 100 ms. On a bus it never
    // receives its own frames, so the monitoring never begins. If a replay passed it its own frames, it would report
    // their absence.
    TestRun run{{"cbx-ao412@3"}};
    run.put(10000, "603#2B17100064000000");
    run.put(20000, "603#2316100132000300");
    run.session->advance_to(Instant{500000});
    EXPECT_THAT(run.log.str(), HasSubstr("583#6016100100000000 T"));
    EXPECT_THAT(run.log.str(), testing::Not(HasSubstr("083#")));
    const auto own = frames_of(run.log.str(), "T");
    EXPECT_GE(std::count(own.begin(), own.end(), "703#7F"), 4);
    EXPECT_EQ(frames_of(replayed("cbx-ao412", 3, run.log.str()), ""), own);
}

TEST(RunSession, SameCallsGiveTheSameLogByteForByte) {
    BusFaultRates faults;
    faults.corrupted = 0.05;
    faults.lost = 0.02;
    faults.seed = 9;
    TestRun one{{"cbx-ao412@3", "ax188001@5"}, {}, faults};
    TestRun two{{"cbx-ao412@3", "ax188001@5"}, {}, faults};
    converse(one);
    converse(two);
    EXPECT_EQ(one.log.str(), two.log.str());
    EXPECT_EQ(one.changes.str(), two.changes.str());
}

TEST(RunSession, EventsKeepTheirTimesWhenTheClockIsReadLate) {
    TestRun often{{"cbx-ao412@3"}};
    TestRun seldom{{"cbx-ao412@3"}};
    for (TestRun* run : {&often, &seldom}) {
        run->put(10000, "603#2B17100064000000");
    }
    for (std::uint64_t us = 10000; us <= 1000000; us += 137) {
        often.session->advance_to(Instant{us});
    }
    often.session->advance_to(Instant{1000000});
    seldom.session->advance_to(Instant{1000000});
    EXPECT_EQ(often.log.str(), seldom.log.str());
}

TEST(RunSession, StimulusAppliesToTheDeviceThatItNamesOrToAllDevices) {
    // From 10 ms on, the selected devices are bus-off and do not answer. Counted frames: the boot-up message and the
    // answer.
    const auto frames = [](const std::string& signal) {
        TestRun run{{"cbx-ao412@3", "cbx-ao412@4"}, {{"here:1", Instant{10000}, signal, 3.0}}};
        run.put(20000, "603#4000100000000000");
        run.put(30000, "604#4000100000000000");
        run.session->advance_to(Instant{40000});
        return std::pair{run.session->traffic()[0].frames, run.session->traffic()[1].frames};
    };
    EXPECT_EQ(frames("no_such_signal"), (std::pair<std::uint64_t, std::uint64_t>{2, 2}));
    EXPECT_EQ(frames("can_state"), (std::pair<std::uint64_t, std::uint64_t>{1, 1}));
    EXPECT_EQ(frames("cbx-ao412@4.can_state"), (std::pair<std::uint64_t, std::uint64_t>{2, 1}));
}

TEST(RunSession, StimuliOfOneTimeApplyInTheOrderInWhichTheyWereAdded) {
    // A hardware fault begins with the planned stimulus and ends with the user's. In another order it would last.
    const Instant time{50000};
    TestRun run{{"cbx-ao412@3"}, {{"plan", time, "hardware_fault", 1.0}}};
    run.session->schedule({"user", time, "hardware_fault", 0.0});
    run.session->advance_to(Instant{100000});
    EXPECT_THAT(frames_of(run.log.str(), "T"),
                testing::ElementsAre("703#00", testing::StartsWith("083#0050"), testing::StartsWith("083#0000")));
    run.session->schedule({"user", Instant{150000}, "hardware_fault", 1.0});
    run.session->schedule({"user", Instant{150000}, "hardware_fault", 0.0});
    run.session->schedule({"user", Instant{140000}, "internal_fault", 1.0});
    run.session->advance_to(Instant{200000});
    EXPECT_THAT(frames_of(run.log.str(), "T"),
                testing::ElementsAre("703#00", testing::_, testing::_, testing::StartsWith("083#1061"),
                                     testing::StartsWith("083#0050"), testing::StartsWith("083#0000")));
}

TEST(RunSession, DeviceOfANodeInBusOffReceivesNothingAndReportsTheRecovery) {
    TestRun run{{"cbx-ao412@3", "cbx-ao412@4"}};
    run.session->advance_to(Instant{10000});
    auto& bus = dynamic_cast<ArbitratedBus&>(run.session->bus());
    bus.switch_off(*run.session->nodes()[0], Instant{10000});
    run.put(11000, "603#4000100000000000");
    run.session->advance_to(Instant{20000});
    const std::string log = run.log.str();
    EXPECT_THAT(log, testing::Not(HasSubstr("583#")));  // the device has not received the request
    run.session->advance_to(Instant{100000});
    // 10 ms + 128 × 11 bits × 8 us: the device has recovered and sends EMCY 8140h
    EXPECT_THAT(run.log.str(), HasSubstr("083#4081"));
}

TEST(RunSession, OutputsOfARunWithSeveralDevicesContainTheDeviceName) {
    TestRun one{{"cbx-ao412@3"}};
    one.session->advance_to(Instant{1000});
    EXPECT_THAT(one.changes.str(), testing::StartsWith("seconds,signal,value\n0.000000,"));
    EXPECT_THAT(one.changes.str(), HasSubstr("0.000000,aout1,0\n"));
    TestRun two{{"cbx-ao412@3", "cbx-ao412@4"}};
    EXPECT_THAT(two.changes.str(), HasSubstr("0.000000,cbx-ao412@4.aout1,0\n"));
}

TEST(LiveTable, TableShowsBusNodesStatesAndLastFrames) {
    TestRun run{{"cbx-ao412@3", "ax188001@20"}};
    run.put(10000, "000#0103");
    run.session->advance_to(Instant{1000000});
    const auto lines = table_lines(*run.session, {"vcan0 is down; waiting for it"}, {100, 24});
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_THAT(lines[0], HasSubstr("inproc  125 kbit/s  load 0.1 %"));
    EXPECT_THAT(lines[2], HasSubstr("cbx-ao412@3         3  operational"));
    EXPECT_THAT(lines[2], HasSubstr("703#00"));
    EXPECT_THAT(lines[3], HasSubstr("ax188001@20        20  pre-operational"));
    EXPECT_EQ(lines[4], "vcan0 is down; waiting for it");
}

TEST(LiveTable, TableFitsTheTerminal) {
    std::vector<std::string> names;
    for (int node = 1; node <= 40; ++node) {
        names.push_back("cbx-ao412@" + std::to_string(node));
    }
    TestRun run{names};
    run.session->advance_to(Instant{100000});
    const auto lines = table_lines(*run.session, {}, {40, 12});
    EXPECT_LE(lines.size(), 11U);
    for (const auto& line : lines) {
        EXPECT_LE(line.size(), 40U);
    }
    EXPECT_THAT(lines.back(), HasSubstr("and 33 more"));
}

TEST(ChosenDevices, AllDevicesOfTheCatalogueRunTogetherWithDifferentNodeIds) {
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    for (ChosenDevice& one : choose_catalogue()) {
        nodes.push_back(std::make_unique<DeviceNode>(one.name, std::move(one.device)));
    }
    ASSERT_EQ(nodes.size(), 4U);
    RunSession session{std::make_unique<ArbitratedBus>("inproc", 125000, BusFaultRates{}), std::move(nodes), {}, {}};
    session.power_on();
    session.advance_to(Instant{100000});
    std::set<int> ids;
    for (std::size_t i = 0; i < 4; ++i) {
        ids.insert(session.nodes()[i]->device().node_id());
        EXPECT_GE(session.traffic()[i].frames, 1U) << session.nodes()[i]->name();
    }
    EXPECT_EQ(ids.size(), 4U);
}

TEST(ChosenDevices, NodeIdAfterTheDeviceNameIsChecked) {
    EXPECT_EQ(choose_device("cbx-ao412@17").name, "cbx-ao412@17");
    for (const char* wrong : {"cbx-ao412@", "cbx-ao412@x", "cbx-ao412@256", "nothing", "cbx-ao412@-1"}) {
        EXPECT_THROW(choose_device(wrong), InputError) << wrong;
    }
}

}  // namespace canproof::host::test
