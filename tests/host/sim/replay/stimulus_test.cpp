// SPDX-License-Identifier: Apache-2.0
// Stimuli as text: fields, times, ranges and types at their limits.
#include "host/sim/replay/stimulus.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

std::vector<Stimulus> read(const std::string& text) {
    std::istringstream in{text};
    return read_stimuli(in, "s.csv");
}

std::string refusal_of(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

/// Returns a device with one input of each type and one output.
Part part() {
    const auto signal = [](const char* name, const char* type, double low, double high, bool input) {
        Signal one;
        one.name = name;
        one.type = type;
        one.input = input;
        one.minimum = low;
        one.maximum = high;
        return one;
    };
    Part made;
    made.signals = {signal("real", "REAL32", -1.5, 2.5, true), signal("exact", "REAL64", 0.0, 1.0, true),
                    signal("number", "INTEGER16", -3.0, 4.0, true), signal("truth", "BOOLEAN", 0.0, 0.0, true),
                    signal("shown", "REAL32", 0.0, 1.0, false)};
    made.signals[3].minimum.reset();
    made.signals[3].maximum.reset();
    return made;
}

std::string verdict(const std::string& signal_and_value) {
    const Part one = part();
    try {
        check_stimuli(read("1.0," + signal_and_value + "\n"), {&one});
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST(StimulusText, StimulusIsReadWithTimeSignalValueAndLineOfTheFile) {
    const auto all = read("seconds,signal,value\n\n0.5,one,1\n0.5,two,-2.5e3\n1.25,three,0x10\n");
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].time, Instant{500000});
    EXPECT_EQ(all[0].signal, "one");
    EXPECT_DOUBLE_EQ(all[0].value, 1.0);
    EXPECT_EQ(all[0].where, "s.csv:3");
    EXPECT_DOUBLE_EQ(all[1].value, -2500.0);
    EXPECT_EQ(all[2].where, "s.csv:5");
    EXPECT_DOUBLE_EQ(all[2].value, 16.0);
}

TEST(StimulusText, RefusalContainsTheLineNumberAndTheRemedy) {
    EXPECT_EQ(refusal_of("1.0;one;2\n"), "s.csv:1: `1.0;one;2` does not have three fields; write seconds,signal,value");
    EXPECT_EQ(refusal_of("1.0,one\n"), "s.csv:1: `1.0,one` does not have three fields; write seconds,signal,value");
    EXPECT_EQ(refusal_of("0.5,one,1\n1.0,one,2x\n"),
              "s.csv:2: value `2x` is not a finite number; write seconds,signal,value");
    for (const char* value : {"", "inf", "-inf", "nan", "1,2", "1e999", " 1", "0x1p-3"}) {
        EXPECT_NE(refusal_of(std::string{"1.0,one,"} + value).find("is not a finite number"), std::string::npos)
            << value;
    }
    EXPECT_EQ(refusal_of("0.500001,one,1\n0.5,one,2\n"), "s.csv:2: time goes backwards; sort the lines by time");
    EXPECT_EQ(refusal_of("0.5,one,1\n0.7,one,2\n0.6,one,3\n"), "s.csv:3: time goes backwards; sort the lines by time");
}

TEST(StimulusText, EmptySignalNameIsRead_AndRefusedByTheRegister) {
    EXPECT_EQ(read("1.0,,5\n").at(0).signal, "");
    EXPECT_NE(verdict(",5").find("there is no input ``"), std::string::npos);
}

TEST(StimulusText, HeadingIsAcceptedInTheFirstLineOnly) {
    EXPECT_EQ(read("seconds,signal,value\n").size(), 0U);
    EXPECT_NE(refusal_of("0.5,one,1\nseconds,signal,value\n"), "taken");
    EXPECT_NE(refusal_of("Seconds,signal,value\n"), "taken");
}

TEST(StimulusValue, OnlyValuesFromTheLowestToTheHighestAreAccepted) {
    for (const char* fits :
         {"real,-1.5", "real,2.5", "real,0.25", "exact,0.5", "number,-3", "number,4", "truth,0", "truth,1"}) {
        EXPECT_EQ(verdict(fits), "taken") << fits;
    }
    EXPECT_EQ(verdict("real,-1.51"), "s.csv:1: real takes values from -1.5 to 2.5, not -1.51");
    EXPECT_EQ(verdict("real,2.51"), "s.csv:1: real takes values from -1.5 to 2.5, not 2.51");
    EXPECT_EQ(verdict("number,5"), "s.csv:1: number takes whole numbers from -3 to 4, not 5");
    EXPECT_EQ(verdict("number,-4"), "s.csv:1: number takes whole numbers from -3 to 4, not -4");
    EXPECT_EQ(verdict("number,0.5"), "s.csv:1: number takes whole numbers from -3 to 4, not 0.5");
    EXPECT_EQ(verdict("truth,2"), "s.csv:1: truth takes whole numbers from 0 to 1, not 2");
    EXPECT_EQ(verdict("truth,-1"), "s.csv:1: truth takes whole numbers from 0 to 1, not -1");
}

TEST(StimulusValue, StimulusOfAnOutputOrUnknownSignalIsRefused) {
    for (const char* none : {"shown,0", "other,0"}) {
        EXPECT_NE(verdict(none).find("there is no input `"), std::string::npos) << none;
    }
}

}  // namespace canproof::host::test
