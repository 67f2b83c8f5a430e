// SPDX-License-Identifier: Apache-2.0
// Candump logs, stimuli and replay: what is read, what is refused and what is written.
#include "host/sim/bus/candump.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "devices/catalogue.hpp"
#include "firmware/base/time.hpp"
#include "host/base/input_error.hpp"
#include "host/base/time_text.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/replay/replay.hpp"
#include "host/sim/replay/stimulus.hpp"

namespace canproof::host {

namespace {

std::string message(const std::string& line) {
    try {
        parse_candump_line(line, "log:7");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string replayed(const std::string& log, const std::string& stimuli, double until, std::string* outputs = nullptr) {
    const auto device = make_device("cbx-ao412");
    std::istringstream log_in{log};
    std::istringstream stimuli_in{stimuli};
    ReplayInput input;
    input.frames = read_candump_log(log_in, "log");
    input.stimuli = read_stimuli(stimuli_in, "stimuli");
    if (until > 0.0) {
        input.until = Instant{static_cast<std::uint64_t>(until * 1e6)};
    }
    std::ostringstream frames;
    std::ostringstream changes;
    replay(*device, input, frames, outputs == nullptr ? nullptr : &changes);
    if (outputs != nullptr) {
        *outputs = changes.str();
    }
    return frames.str();
}

}  // namespace

TEST(Candump, WrittenLinesAreReadBack) {
    for (const char* line : {"(1.000000) can0 603#2B116401B33E0000", "(0.000001) vcan3 080#", "(12.345678) can0 703#R",
                             "(2.000000) can0 303#R8", "(3.000000) can0 1FFFFFFF#0102"}) {
        EXPECT_EQ(format_candump_line(parse_candump_line(line, "log:1")), line);
    }
}

TEST(Candump, RefusalContainsTheLineNumberAndAnExampleOfAValidLine) {
    for (const char* line :
         {"", "603#00", "(1.0) can0", "1.0 can0 603#00", "(1.0000000) can0 603#00", "(x) can0 603#00", "(1.0) can0 603",
          "(1.0) can0 6#00", "(1.0) can0 603#0", "(1.0) can0 603#001122334455667788", "(1.0) can0 603#GG",
          "(1.0) can0 FFF#00", "(1.0) can0 603#R9", "(1.0) can0 603#00 more"}) {
        EXPECT_EQ(message(line).rfind("log:7: ", 0), 0U) << line;
        EXPECT_NE(message(line).find("a line of a candump log reads"), std::string::npos) << line;
    }
}

TEST(Candump, TimeMustNotGoBackwards) {
    std::istringstream in{"(2.0) can0 080#\n\n(1.0) can0 080#\n"};
    try {
        read_candump_log(in, "bus.log");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "bus.log:3: time goes backwards; sort the log by time");
    }
}

TEST(Candump, RawLengthCodesErrorFramesAndAByteOrderMarkAreAccepted) {
    // candump -L writes a raw length code of 9 to 15 after `_`, and an error frame with bit 29 of its identifier set
    EXPECT_EQ(format_frame(parse_candump_line("(1.0) can0 123#0102030405060708_F", "log:1").frame),
              "123#0102030405060708");
    EXPECT_EQ(parse_candump_line("(1.0) can0 123#R8_9", "log:1").frame.length, 8U);
    for (const char* line : {"(1.0) can0 123#01_9", "(1.0) can0 123#0102030405060708_8",
                             "(1.0) can0 123#0102030405060708_", "(1.0) can0 60000004#00", "(1.0) can0 20000004#0"}) {
        EXPECT_EQ(message(line).rfind("log:7: ", 0), 0U) << line;
    }
    std::istringstream in{
        "\xEF\xBB\xBF(1.0) can0 080#\r\n(2.0) can0 20000004#0001000000000000\n"
        "(3.0) can0 123#0102030405060708_9\n"};
    CandumpReader reader{in, "bus.log"};
    LoggedFrame frame;
    ASSERT_TRUE(reader.next(frame));
    EXPECT_EQ(format_candump_line(frame), "(1.000000) can0 080#");
    ASSERT_TRUE(reader.next(frame));
    EXPECT_EQ(frame.time.us, 3000000U);
    EXPECT_FALSE(reader.next(frame));
    EXPECT_EQ(reader.counts().error_frames, 1U);
    EXPECT_EQ(reader.counts().coded_lengths, 1U);
}

TEST(Candump, LineOf100000CharactersIsRefused) {
    std::istringstream in{std::string(100000, '\0')};
    EXPECT_THROW(read_candump_log(in, "zero"), InputError);
    std::istringstream stimuli{std::string(100000, '1')};
    EXPECT_THROW(read_stimuli(stimuli, "ones"), InputError);
}

TEST(StimulusFile, LineWithoutThreeFieldsOrWithAnInvalidNumberIsRefused) {
    for (const char* text :
         {"1.0,can_state", "1.0,can_state,x", "1.0,can_state,", "x,can_state,1", "1.0,can_state,nan"}) {
        std::istringstream in{text};
        EXPECT_THROW(read_stimuli(in, "s.csv"), InputError) << text;
    }
}

// Replays telegrams of the manual twice; both logs must have the same bytes as written here.
TEST(Replay, TwoReplaysOfTheTelegramsOfTheManualBothGiveTheExpectedFrames) {
    const std::string log = "(1.000000) can0 603#2B116401B33E0000\n(1.100000) can0 603#4000100000000000\n";
    const std::string expected =
        "(0.000000) can0 703#00\n(1.000000) can0 583#6011640100000000\n(1.100000) can0 583#4300100091010800\n";
    EXPECT_EQ(replayed(log, "", 0.0), expected);
    EXPECT_EQ(replayed(log, "", 0.0), expected);
}

TEST(Replay, ReplayContinuesUntilTheGivenTime) {
    // a heartbeat of 100 ms is set at 0.05 s, so heartbeats are due at 0.15, 0.25 and 0.35 s
    const std::string log = "(0.050000) can7 603#2B17100064000000\n";
    EXPECT_EQ(replayed(log, "", 0.3),
              "(0.000000) can7 703#00\n(0.050000) can7 583#6017100000000000\n(0.150000) can7 703#7F\n(0.250000) can7 "
              "703#7F\n");
}

TEST(Replay, StimuliTakeEffect_AndOutputsAreWritten) {
    std::string outputs;
    const std::string frames = replayed("(0.010000) can0 603#2B11640108000000\n",
                                        "seconds,signal,value\n0.020000,internal_fault,1\n", 0.03, &outputs);
    EXPECT_EQ(frames,
              "(0.000000) can0 703#00\n(0.010000) can0 583#6011640100000000\n(0.020000) can0 083#1061010100000000\n");
    // one step is 1 mV × 30.9 / 12.4 = 2.49194 mV; error mode 1 sets the error value 0
    EXPECT_NE(outputs.find("0.010000,aout1,0.00249194\n"), std::string::npos);
    EXPECT_NE(outputs.find("0.020000,aout1,0\n"), std::string::npos);
}

TEST(Replay, StimuliAtTime0ApplyBeforePowerOn) {
    EXPECT_EQ(replayed("", "0.0,switch_low,5\n", 0.0), "(0.000000) can0 705#00\n");
}

TEST(Replay, ReplayStartsAtTheFirstFrameOfALogWithClockTimes) {
    // The device powers on at the time of the first frame, sends its boot-up message at once, then answers. The second
    // frame follows 20 ms later.
    const std::string log =
        "(1436509052.249713) vcan0 603#4000100000000000\n(1436509052.269713) vcan0 603#4000100000000000\n";
    EXPECT_EQ(replayed(log, "", 0.0),
              "(1436509052.249713) vcan0 703#00\n(1436509052.249713) vcan0 583#4300100091010800\n"
              "(1436509052.269713) vcan0 583#4300100091010800\n");
    std::string outputs;
    replayed(log, "1436509052.260000,internal_fault,1\n", 0.0, &outputs);
    EXPECT_EQ(outputs.rfind("seconds,signal,value\n1436509052.249713,", 0), 0U);
}

TEST(Replay, DeviceIsPoweredOnAtTheGivenStart_AndEarlierFramesAreLeftOut) {
    const auto device = make_device("cbx-ao412");
    device->set_node_id(3);
    std::istringstream log{"(1.0) can0 603#4000100000000000\n(3.0) can0 603#4000100000000000\n"};
    ReplayInput input;
    input.frames = read_candump_log(log, "log");
    input.start = Instant{2000000};
    std::vector<std::string> told;
    input.notice = [&told](const std::string& text) { told.push_back(text); };
    std::ostringstream frames;
    replay(*device, input, frames, nullptr);
    EXPECT_EQ(frames.str(), "(2.000000) can0 703#00\n(3.000000) can0 583#4300100091010800\n");
    EXPECT_EQ(told, std::vector<std::string>{"1 frames before the start are left out"});
    input.until = Instant{1000000};
    EXPECT_THROW(replay(*make_device("cbx-ao412"), input, frames, nullptr), InputError);
}

TEST(Replay, GapOfYearsBetweenFramesIsShortenedToAnHour) {
    // The heartbeat period is 60 s. The replay keeps one hour of the silence, with 60 heartbeats instead of the 24
    // million of 45 years.
    const std::string log = "(1.000000) can0 603#2B17100060EA0000\n(1436509052.249713) can0 603#4000100000000000\n";
    const std::string frames = replayed(log, "", 0.0);
    EXPECT_EQ(std::count(frames.begin(), frames.end(), '\n'), 1 + 1 + 60 + 1);
    EXPECT_NE(frames.find("(3601.000000) can0 703#7F\n(1436509052.249713) can0 583#4300100091010800\n"),
              std::string::npos);
}

TEST(Replay, OutputTimesNeverDecrease) {
    std::string outputs;
    replayed("(1.0) can0 603#2B11640108000000\n", "3,internal_fault,1\n3.5,internal_fault,0\n", 5.0, &outputs);
    std::istringstream lines{outputs.substr(outputs.find('\n') + 1)};
    Instant last{};
    for (std::string line; std::getline(lines, line);) {
        const Instant time = parse_seconds(line.substr(0, line.find(',')), "outputs");
        EXPECT_LE(last, time) << line;
        last = time;
    }
    EXPECT_LE(Instant{3000000}, last);
}

TEST(Replay, DeviceDoesNotReceiveItsOwnFrameFromALogWithoutDirectionMarks) {
    // The device monitors the heartbeat of its own node-ID (1016h consumer heartbeat time). It sends this heartbeat
    // every 100 ms, and a device on a bus never receives its own frames.
    const std::string requests = "(0.010000) can0 603#2B17100064000000\n(0.020000) can0 603#2316100132000300\n";
    const std::string beats = "(0.110050) can0 703#7F\n(0.210050) can0 703#7F\n";
    EXPECT_EQ(replayed(requests + beats, "", 0.25), replayed(requests, "", 0.25));
    // A frame marked as received comes from another node. The device receives this heartbeat, and reports 50 ms later
    // that the next one is missing.
    EXPECT_NE(replayed(requests + "(0.110050) can0 703#7F R\n", "", 0.25).find("083#"), std::string::npos);
}

TEST(Replay, UnknownSignalIsRefused) {
    EXPECT_THROW(replayed("", "0.5,temperature,20\n", 1.0), InputError);
}

TEST(StimulusFile, SignalsAndValuesAreCheckedAgainstTheRegister) {
    const LoadResult loaded = load_register(embedded_spec());
    const Part& part = *loaded.content.part("cbx-ao412");
    const auto refusal = [&](const std::string& text) {
        std::istringstream in{text};
        try {
            check_stimuli(read_stimuli(in, "s.csv"), {&part});
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    EXPECT_EQ(refusal("0.5,switch_low,15\n1.0,can_overrun,1\n"), "");
    EXPECT_EQ(refusal("0.5,can_state,0\n1.0,switch_low,16\n"),
              "s.csv:2: switch_low takes whole numbers from 0 to 15, not 16");
    EXPECT_EQ(refusal("1.0,can_overrun,0.5\n"), "s.csv:1: can_overrun takes whole numbers from 0 to 1, not 0.5");
    EXPECT_EQ(refusal("1.0,aout1,1\n"), "s.csv:1: there is no input `aout1`; `canproof signals` lists the inputs");
}

TEST(StimulusFile, ValueWithoutADeviceNameMustFitEveryDeviceWithTheSignal) {
    const LoadResult loaded = load_register(embedded_spec());
    // one device with a `supply_voltage` up to 70 V and an invented one up to 10 V
    Part other = *loaded.content.part("ax060805");
    for (Signal& signal : other.signals) {
        signal.maximum = signal.name == "supply_voltage" ? 10.0 : signal.maximum;
    }
    std::istringstream in{"1.0,supply_voltage,11\n"};
    const auto stimuli = read_stimuli(in, "s.csv");
    EXPECT_NO_THROW(check_stimuli(stimuli, {loaded.content.part("ax060805")}));
    EXPECT_THROW(check_stimuli(stimuli, {loaded.content.part("ax060805"), &other}), InputError);
}

TEST(StimulusFile, NoiseSeedOutsideUnsigned32IsRefused) {
    const LoadResult loaded = load_register(embedded_spec());
    for (const char* value : {"-1", "4294967296", "1e300", "0.5"}) {
        std::istringstream in{std::string{"1.0,noise_seed,"} + value};
        EXPECT_THROW(check_stimuli(read_stimuli(in, "s.csv"), {loaded.content.part("ax060805")}), InputError) << value;
    }
}

TEST(StimulusFile, EveryNumericSignalOfTheRegisterHasARange) {
    const LoadResult loaded = load_register(embedded_spec());
    for (const Part& part : loaded.content.parts) {
        for (const Signal& signal : part.signals) {
            EXPECT_TRUE(signal.type == "BOOLEAN" || (signal.minimum && signal.maximum)) << signal.id;
        }
    }
}

TEST(Catalogue, DeviceCatalogueCreatesOnlyDevicesThatItLists) {
    EXPECT_NE(make_device("cbx-ao412"), nullptr);
    EXPECT_EQ(make_device("cbx-ao413"), nullptr);
}

}  // namespace canproof::host
