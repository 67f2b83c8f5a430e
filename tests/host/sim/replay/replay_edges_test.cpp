// SPDX-License-Identifier: Apache-2.0
// Calls of a device during a replay, and their times: start, end, silences, lines with T or R, and equal times, with
// limits tested to one microsecond.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "host/base/input_error.hpp"
#include "host/sim/replay/replay.hpp"
#include "tests/host/sim/replay/recording_device.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class ReplayEdges : public testing::Test {
  protected:
    void play(RecordingDevice& device, const std::string& log, const std::string& stimuli = "") {
        std::istringstream log_in{log};
        std::istringstream stimuli_in{stimuli};
        input.frames = read_candump_log(log_in, "log");
        input.stimuli = read_stimuli(stimuli_in, "stimuli");
        input.notice = [this](const std::string& text) { notices.push_back(text); };
        std::ostringstream frames_out;
        std::ostringstream outputs_out;
        replay(device, input, frames_out, &outputs_out);
        frames = frames_out.str();
        outputs = outputs_out.str();
    }

    ReplayInput input;
    std::string frames;
    std::string outputs;
    std::vector<std::string> notices;
};

}  // namespace

TEST_F(ReplayEdges, ReplayWithoutFramesOnlyPowersTheDeviceOnAtTime0) {
    RecordingDevice device{milliseconds(10)};
    play(device, "");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on"));
    EXPECT_EQ(outputs, "seconds,signal,value\n0.000000,one,0\n0.000000,two,0\n");
    EXPECT_THAT(notices, IsEmpty());
}

TEST_F(ReplayEdges, ReplayEndsAtTheLastLogLine_AfterDeviceWorkDueAtThatTime) {
    RecordingDevice device{milliseconds(10)};
    play(device, "(0.020000) can0 080#\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.010000 due", "0.020000 due", "0.020000 080#"));
    RecordingDevice before{milliseconds(10)};
    play(before, "(0.019999) can0 080#\n");
    EXPECT_THAT(before.told, ElementsAre("0.000000 on", "0.010000 due", "0.019999 080#"));
}

TEST_F(ReplayEdges, OptionUntilIncludesEventsAtItsTimeAndOmitsLaterEvents) {
    RecordingDevice device{milliseconds(10)};
    input.until = Instant{20000};
    play(device, "(0.005000) can0 080#\n(0.020000) can0 081#\n(0.020001) can0 082#\n",
         "0.020000,one,1\n0.020001,two,1\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.005000 080#", "0.010000 due", "0.020000 due",
                                         "0.020000 one=1", "0.020000 081#"));
    RecordingDevice shorter{milliseconds(10)};
    input.until = Instant{19999};
    play(shorter, "");
    EXPECT_THAT(shorter.told, ElementsAre("0.000000 on", "0.010000 due"));
}

TEST_F(ReplayEdges, OptionUntilMayEqualTheStartButNotPrecedeIt) {
    RecordingDevice device;
    input.start = Instant{2000000};
    input.until = Instant{2000000};
    play(device, "(2.000000) can0 080#\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.000000 080#"));
    input.until = Instant{1999999};
    try {
        play(device, "");
        FAIL() << "played";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "--until 1.999999 is before the start at 2.000000; write a later --until or an earlier --start");
    }
}

TEST_F(ReplayEdges, PowerOnIsAtTime0_OrAtTheFirstFrameIfThatIsLaterThanAnHour) {
    RecordingDevice early;
    play(early, "(3600.000000) can0 080#\n");
    EXPECT_THAT(early.told, ElementsAre("0.000000 on", "3600.000000 080#"));
    EXPECT_THAT(notices, IsEmpty());
    RecordingDevice late;
    play(late, "(3600.000001) can0 080#\n");
    EXPECT_THAT(late.told, ElementsAre("0.000000 on", "0.000000 080#"));
    EXPECT_THAT(
        notices,
        ElementsAre(
            "power-on is at 3600.000001, the time of the first frame of the log; --start SECONDS sets another time"));
}

TEST_F(ReplayEdges, OptionStartOmitsEarlierFramesAndAppliesEarlierStimuli) {
    RecordingDevice device;
    input.start = Instant{2000000};
    play(device, "(1.000000) can0 080#\n(1.999999) can0 081#\n(2.000000) can0 082#\n(2.500000) can0 083#\n",
         "1.0,one,1\n2.0,one,2\n2.000001,one,3\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 one=1", "0.000000 one=2", "0.000000 on", "0.000000 082#",
                                         "0.000001 one=3", "0.500000 083#"));
    EXPECT_THAT(notices, ElementsAre("2 frames before the start are left out"));
    EXPECT_EQ(outputs, "seconds,signal,value\n2.000000,one,2\n2.000000,two,0\n2.000001,one,3\n");
}

TEST_F(ReplayEdges, WrittenFramesKeepLogTimesAndInterfaceWhenTheStartIsLater) {
    RecordingDevice device;
    input.start = Instant{2000000};
    play(device, "(2.500000) vcan7 300#05\n");
    EXPECT_EQ(frames, "(2.500000) vcan7 301#05\n");
    RecordingDevice alone{milliseconds(10), "705#7F"};
    input.start.reset();
    input.until = Instant{10000};
    play(alone, "");
    EXPECT_EQ(frames, "(0.010000) can0 705#7F\n");
}

TEST_F(ReplayEdges, GapOfAnHourIsPlayedInFullAndALongerGapIsShortenedToAnHour) {
    RecordingDevice whole;
    play(whole, "(1.000000) can0 080#\n(3601.000000) can0 081#\n");
    EXPECT_THAT(whole.told, ElementsAre("0.000000 on", "1.000000 080#", "3601.000000 081#"));
    EXPECT_THAT(notices, IsEmpty());
    RecordingDevice shortened;
    play(shortened, "(1.000000) can0 080#\n(3602.999999) can0 300#\n(3604.000000) can0 300#01\n");
    EXPECT_THAT(shortened.told, ElementsAre("0.000000 on", "1.000000 080#", "3601.000000 300#", "3602.000001 300#01"));
    EXPECT_THAT(notices, ElementsAre("nothing happens before 3602.999999; the replay leaves out 1 s"));
    EXPECT_EQ(frames, "(3602.999999) can0 301#\n(3604.000000) can0 301#01\n");  // the times are those of the log
}

TEST_F(ReplayEdges, GapOverAnHourIsShortenedAlsoWhenTheReplayStartsLater) {
    RecordingDevice device;
    input.start = Instant{2000000};
    play(device, "(3.000000) can0 080#\n(3606.000000) can0 081#\n(7209.500000) can0 082#\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "1.000000 080#", "3601.000000 081#", "7201.000000 082#"));
    EXPECT_THAT(notices, ElementsAre("nothing happens before 3606.000000; the replay leaves out 3 s",
                                     "nothing happens before 7209.500000; the replay leaves out 3 s"));
}

TEST_F(ReplayEdges, DeviceRunsUntilTheGivenTimeDespiteALongGapInTheLog) {
    RecordingDevice device{milliseconds(3000000)};
    input.until = Instant{9000000000U};
    play(device, "(1.000000) can0 080#\n");
    EXPECT_THAT(device.told,
                ElementsAre("0.000000 on", "1.000000 080#", "3000.000000 due", "6000.000000 due", "9000.000000 due"));
}

TEST_F(ReplayEdges, OptionUntilInsideALongGapPlaysOneHourOfTheGap) {
    RecordingDevice device{milliseconds(1800000)};
    input.until = Instant{9000000000U};
    play(device, "(1.000000) can0 080#\n(100000.000000) can0 081#\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "1.000000 080#", "1800.000000 due", "3600.000000 due"));
    // 9000 s - (1 s + 3600 s) = 5399 s
    EXPECT_THAT(notices, ElementsAre("nothing happens before 9000.000000; the replay leaves out 5399 s"));
    notices.clear();
    RecordingDevice later{milliseconds(1800000)};
    input.until = Instant{1003601000000U};
    play(later, "(1.000000) can0 080#\n(2000000.000000) can0 081#\n");
    // 1,003,601 s - (1 s + 3600 s)
    EXPECT_THAT(notices, ElementsAre("nothing happens before 1003601.000000; the replay leaves out 1000000 s"));
}

TEST_F(ReplayEdges, OptionUntilInsideALongGapBeforeAStimulusPlaysOneHourOfTheGap) {
    RecordingDevice device{milliseconds(1800000)};
    input.until = Instant{9000000000U};
    play(device, "(1.000000) can0 080#\n", "100000.000000,one,1\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "1.000000 080#", "1800.000000 due", "3600.000000 due"));
    // 9000 s - (1 s + 3600 s) = 5399 s
    EXPECT_THAT(notices, ElementsAre("nothing happens before 9000.000000; the replay leaves out 5399 s"));
}

TEST_F(ReplayEdges, OptionUntilIsATimeOfTheLogEvenWhenTheStartIsLater) {
    RecordingDevice device{milliseconds(10)};
    input.start = Instant{2000000};
    input.until = Instant{2010000};
    play(device, "");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.010000 due"));
}

TEST_F(ReplayEdges, FrameThatASourceLeavesWhenItReportsItsEndIsIgnored) {
    input.source = [](LoggedFrame& frame) {
        frame = {Instant{7200000000U}, "vcan9", parse_frame("080#", "test"), LogMark::received};
        return false;
    };
    RecordingDevice device{milliseconds(10), "705#7F"};
    input.until = Instant{20000};
    play(device, "");
    EXPECT_EQ(frames, "(0.010000) can0 705#7F\n(0.020000) can0 705#7F\n");
    EXPECT_THAT(notices, IsEmpty());
    RecordingDevice later{milliseconds(10)};
    input.start = Instant{8000000000U};
    input.until = Instant{8000000000U};
    play(later, "");
    EXPECT_THAT(later.told, ElementsAre("0.000000 on"));
}

TEST_F(ReplayEdges, FramesSentAfterTheLastLogLineAreWrittenAfterWaitingFrames) {
    RecordingDevice device{milliseconds(100), "705#7F"};
    input.until = Instant{250000};
    play(device, "(0.050000) can0 300#05 R\n");
    EXPECT_EQ(frames, "(0.050000) can0 301#05\n(0.100000) can0 705#7F\n(0.200000) can0 705#7F\n");
}

TEST_F(ReplayEdges, StimulusCountsAsAnEventSoTheGapAroundItIsNotShortened) {
    RecordingDevice device;
    play(device, "(1.000000) can0 080#\n", "3601.000000,one,1\n7200.000000,one,2\n");
    EXPECT_THAT(notices, IsEmpty());
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "1.000000 080#", "3601.000000 one=1", "7200.000000 one=2"));
}

TEST_F(ReplayEdges, FrameSourceReplacesTheListOfFrames) {
    RecordingDevice device;
    int left = 2;
    input.source = [&left](LoggedFrame& frame) {
        frame = {Instant{static_cast<std::uint64_t>(3 - left) * 1000U}, "can0", parse_frame("080#", "test")};
        return left-- > 0;
    };
    play(device, "(0.500000) can0 081#\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.001000 080#", "0.002000 080#"));
}

TEST_F(ReplayEdges, OutputsAreWrittenOnlyWhenTheyChange) {
    RecordingDevice device;
    play(device, "(0.001000) can0 080#\n(0.004000) can0 080#\n", "0.002,two,0.5\n0.003,two,0.5\n0.005,two,1234567\n");
    EXPECT_EQ(outputs,
              "seconds,signal,value\n0.000000,one,0\n0.000000,two,0\n0.002000,two,0.5\n0.005000,two,1.23457e+06\n");
}

TEST_F(ReplayEdges, UnknownSignalIsReportedWithItsTime) {
    RecordingDevice device;
    try {
        play(device, "", "0.5,three,1\n");
        FAIL() << "played";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "stimulus at 0.500000 s: there is no input `three`; `canproof signals` lists the inputs");
    }
}

TEST_F(ReplayEdges, DirectionMarksSelectTheFramesThatTheDeviceReceives) {
    RecordingDevice device;
    play(device,
         "(0.001000) can0 300#05 R\n(0.002000) can0 301#05 T\n(0.003000) can0 301#05 T\n(0.004000) can0 301#05 R\n");
    // the device does not receive its own frame once; it receives a second equal frame, and the frame that is marked as
    // received
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.001000 300#05", "0.003000 301#05", "0.004000 301#05"));
    EXPECT_EQ(frames, "(0.002000) can0 301#05\n");
}

TEST_F(ReplayEdges, FrameMarkedAsReceivedIsNotMatchedAsAnEcho) {
    RecordingDevice device;
    play(device, "(0.001000) can0 300#05 R\n(0.002000) can0 301#05 R\n(0.003000) can0 301#05 T\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.001000 300#05", "0.002000 301#05"));
    EXPECT_EQ(frames, "(0.003000) can0 301#05\n");
}

TEST_F(ReplayEdges, WaitingFrameIsWrittenAfterASecondWithoutItsEcho) {
    RecordingDevice device;
    play(device,
         "(0.001000) can0 300#05 R\n(1.001000) can0 080#00 R\n(1.001001) can0 080#01 R\n(1.500000) can0 300#06 R\n"
         "(1.600000) can0 301#06 T\n");
    EXPECT_EQ(frames, "(0.001000) can0 301#05\n(1.600000) can0 301#06\n");
}

TEST_F(ReplayEdges, EqualWaitingFramesAreMatchedInTheirOrder) {
    RecordingDevice device;
    play(device, "(0.001000) can0 300#05 R\n(0.002000) can0 300#05 R\n(0.003000) can0 301#05 T\n");
    EXPECT_EQ(frames, "(0.003000) can0 301#05\n(0.002000) can0 301#05\n");  // the second answer is not in the log
}

TEST_F(ReplayEdges, WaitingFramesAreWrittenBeforeAShortenedGap) {
    RecordingDevice device;
    play(device, "(1.000000) can0 300#05 R\n(9000.000000) can0 080# R\n");
    EXPECT_EQ(frames, "(1.000000) can0 301#05\n");
    EXPECT_THAT(notices, SizeIs(1));
}

TEST_F(ReplayEdges, AtEqualTimesDueWorkPrecedesStimuliAndStimuliPrecedeFrames) {
    RecordingDevice device{milliseconds(10)};
    play(device, "(0.010000) can0 081#\n(0.010000) can0 080#\n", "0.010000,two,1\n0.010000,one,1\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "0.010000 due", "0.010000 two=1", "0.010000 one=1",
                                         "0.010000 081#", "0.010000 080#"));
}

TEST_F(ReplayEdges, EchoInALogWithoutDirectionsIsReceivedIfItIsOverAMinuteLate) {
    RecordingDevice device;
    play(device,
         "(1.000000) can0 300#05\n(61.000000) can0 301#05\n(62.000000) can0 300#06\n(122.000001) can0 301#06\n");
    EXPECT_THAT(device.told, ElementsAre("0.000000 on", "1.000000 300#05", "62.000000 300#06", "122.000001 301#06"));
}

}  // namespace canproof::host::test
