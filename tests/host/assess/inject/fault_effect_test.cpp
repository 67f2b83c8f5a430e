// SPDX-License-Identifier: Apache-2.0
// Tests how the effect of an injected fault is derived from the frames and the outputs of a device with node-ID 5.
#include "host/assess/inject/fault_effect.hpp"

#include <gtest/gtest.h>

#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

const std::string frames =
    "(0.000000) can0 705#00\n"
    "(0.100000) can0 185#0102\n"
    "(0.150000) can0 705#05\n"
    "(0.200000) can0 185#0304\n"
    "(0.250000) can0 585#4300100092010200\n";
const std::string outputs =
    "seconds,signal,value\n"
    "0.000000,relay,0\n"
    "0.000000,volts,0\n"
    "0.100000,volts,5\n"
    "0.200000,relay,1\n";

std::string without(std::string text, const std::string& line) {
    const auto at = text.find(line);
    EXPECT_NE(at, std::string::npos);
    return text.erase(at, line.size());
}

FaultEffect effect(const std::string& faulty_frames, const std::string& faulty_outputs) {
    return effect_of(read_run(frames, outputs), read_run(faulty_frames, faulty_outputs));
}

}  // namespace

TEST(FaultEffect, FaultThatChangesNothingIsMasked) {
    EXPECT_EQ(effect(frames, outputs), FaultEffect::masked);
}

TEST(FaultEffect, AdditionalEmergencyMessageIsClassifiedAsAnEmergencyEffect) {
    const std::string emergency = "(0.260000) can0 085#0010810000000000\n";
    EXPECT_EQ(effect(frames + emergency, outputs + "0.260000,volts,9\n"), FaultEffect::emergency);
    // The run without the fault sends this message once: a second one is new.
    EXPECT_EQ(effect_of(read_run(frames + emergency, outputs), read_run(frames + emergency + emergency, outputs)),
              FaultEffect::emergency);
    EXPECT_EQ(effect_of(read_run(frames + emergency, outputs), read_run(frames + emergency, outputs)),
              FaultEffect::masked);
}

TEST(FaultEffect, SyncIsNoEmergencyMessage) {
    EXPECT_EQ(effect(frames + "(0.260000) can0 080#\n", outputs), FaultEffect::wrong_answer);
}

TEST(FaultEffect, ChangedMissingOrExtraErrorControlMessageIsANetworkEffect) {
    std::string changed = frames;
    changed.replace(changed.find("705#05"), 6, "705#7F");
    EXPECT_EQ(effect(changed, outputs), FaultEffect::network);
    EXPECT_EQ(effect(without(frames, "(0.150000) can0 705#05\n"), outputs), FaultEffect::network);
    EXPECT_EQ(effect(frames + "(0.260000) can0 705#00\n", outputs), FaultEffect::network);
}

TEST(FaultEffect, OutputThatStaysOffOrIsSwitchedOffIsSafe) {
    EXPECT_EQ(effect(frames, without(outputs, "0.200000,relay,1\n")), FaultEffect::safe_state);
    EXPECT_EQ(effect(frames, outputs + "0.300000,volts,0\n"), FaultEffect::safe_state);
}

TEST(FaultEffect, DifferentOrEarlyOutputIsAWrongOutput) {
    EXPECT_EQ(effect(frames, outputs + "0.300000,volts,6\n"), FaultEffect::wrong_output);
    // At 0.3 s, volts becomes 7 in the run without the fault, but stays 5 in the run with the fault.
    const std::string rising = outputs + "0.300000,volts,7\n";
    EXPECT_EQ(effect_of(read_run(frames, rising), read_run(frames, outputs)), FaultEffect::wrong_output)
        << "the output kept an old value";
    // The relay is on 0.1 s too early.
    EXPECT_EQ(effect(frames,
                     "seconds,signal,value\n0.000000,relay,0\n0.000000,volts,0\n"
                     "0.100000,relay,1\n0.100000,volts,5\n"),
              FaultEffect::wrong_output);
}

TEST(FaultEffect, PdoWithDifferentOrOlderDataIsAWrongPdo) {
    EXPECT_EQ(effect(without(frames, "(0.200000) can0 185#0304\n") + "(0.260000) can0 185#0305\n", outputs),
              FaultEffect::wrong_pdo);
    // Frozen: 0102 was right at 0.1 s, but the value of 0.2 s is 0304.
    EXPECT_EQ(effect(frames + "(0.300000) can0 185#0102\n", outputs), FaultEffect::wrong_pdo);
}

TEST(FaultEffect, MissingPdoAndExtraCopyOfAPdoBothCountAsMissingPdo) {
    EXPECT_EQ(effect(without(frames, "(0.200000) can0 185#0304\n"), outputs), FaultEffect::missing_pdo);
    EXPECT_EQ(effect(frames + "(0.300000) can0 185#0304\n", outputs), FaultEffect::missing_pdo);
}

TEST(FaultEffect, MissingSdoAnswerIsClassifiedAsAWrongAnswer) {
    EXPECT_EQ(effect(without(frames, "(0.250000) can0 585#4300100092010200\n"), outputs), FaultEffect::wrong_answer);
}

TEST(FaultEffect, OutputLineWithoutValueIsRefused) {
    EXPECT_THROW(read_run(frames, "seconds,signal,value\n0.1,relay\n"), InputError);
}

}  // namespace canproof::host::test
