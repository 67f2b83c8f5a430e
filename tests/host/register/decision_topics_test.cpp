// SPDX-License-Identifier: Apache-2.0
// Tests the comparison of items that answer the same topic: of devices of one maker, and of a device with the shared
// requirements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/register/fingerprint.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

const std::string other_file = "spec/devices/lid/items.toml";

/// Returns a requirement with the topic heartbeat.range in line 7, its choice in line 8, and further lines.
std::string item(const std::string& id, const std::string& source, const std::string& choice,
                 const std::string& last_lines = "") {
    return "[[requirement]]\nid = \"" + id + "\"\ntext = \"The box is square.\"\nsource = [\"" + source +
           "\"]\nkind = \"functional\"\nverify = [\"test\"]\ntopic = \"heartbeat.range\"\nchoice = \"" + choice +
           "\"\n" + last_lines;
}

std::string of_box(const std::string& choice, const std::string& last_lines = "") {
    return item("AO4-R-1", "M1:1", choice, last_lines);
}
std::string of_lid(const std::string& choice, const std::string& last_lines = "") {
    return item("INC-R-1", "M1:1", choice, last_lines);
}
std::string of_all(const std::string& choice, const std::string& last_lines = "") {
    return item("CO-R-1", "CiA301:7", choice, last_lines);
}

/// Loads the small register, a second device `lid` with prefix INC, and the given items.
LoadResult loaded(const std::string& box, const std::string& lid, const std::string& shared = "",
                  const std::string& maker_of_lid = "Nobody") {
    SpecFiles files = with(items_file, box);
    std::string device = files.at(device_file);
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"box\"", "\"lid\""},
                                   {"B.1", "L.1"},
                                   {"\"AO4\"", "\"INC\""},
                                   {"\"Nobody\"", "\"" + maker_of_lid + "\""}}) {
        device.replace(device.find(from), from.size(), to);
    }
    files["spec/devices/lid/device.toml"] = device;
    files[other_file] = lid;
    files[shared_file] = shared;
    return load_register(files);
}

/// The text of a decision, without which the register of the device `box` is not complete.
const std::string decision_of_box =
    "[[decision]]\nid = \"AO4-D-1\"\nquestion = \"?\"\nreadings = [ { says = \"a\", source = \"M1:1\" }, { says = "
    "\"b\", "
    "source = \"M1:2.1\" } ]\nchosen = \"a\"\nbecause = \"safer failure\"\nseverity = \"low\"\nnone = \"-\"\n";
const std::string differs = "differs = \"its manual says so in 1\"\n";
const std::string overrides = "overrides = \"its manual says so in 1\"\n";

}  // namespace

TEST(DecisionTopics, DevicesOfOneMakerWithEqualAnswersAreAccepted) {
    EXPECT_EQ(all_faults(loaded(of_box("any"), of_lid("any"))), "");
}

TEST(DecisionTopics, DevicesOfOneMakerWithDifferentAnswersAreReported) {
    EXPECT_EQ(all_faults(loaded(of_box("any"), of_lid("some"))),
              "spec/devices/lid/items.toml:7: INC-R-1 chooses some for topic heartbeat.range, but AO4-R-1 "
              "(spec/devices/box/items.toml:7) chooses any for the same manufacturer; give the same answer, or give "
              "the reason "
              "in `differs = …` of one of the two items\n");
}

TEST(DecisionTopics, ReasonToDifferAtOneOfTwoDevicesIsEnough) {
    EXPECT_EQ(all_faults(loaded(of_box("any", differs), of_lid("some"))), "");
    EXPECT_EQ(all_faults(loaded(of_box("any"), of_lid("some", differs))), "");
}

TEST(DecisionTopics, ReasonToDifferAppliesToAllItemsOfItsDevice) {
    std::string again = of_box("any", differs);
    again.replace(again.find("R-1"), 3, "R-2");
    EXPECT_EQ(all_faults(loaded(of_box("any") + again, of_lid("some"))), "");
}

TEST(DecisionTopics, DevicesOfTwoMakersMayHaveDifferentAnswers) {
    EXPECT_EQ(all_faults(loaded(of_box("any"), of_lid("some"), "", "Somebody")), "");
    EXPECT_THAT(all_faults(loaded(of_box("any", differs) + decision_of_box, of_lid("some"), "", "Somebody")),
                HasSubstr("items.toml:7: AO4-R-1 gives a reason to differ, but no device of the same manufacturer "
                          "chooses differently"))
        << "a reason that explains nothing misleads";
}

TEST(DecisionTopics, DeviceThatContradictsASharedRequirementIsReported) {
    EXPECT_EQ(
        all_faults(loaded(of_box("any"), of_lid("some"), of_all("any"), "Somebody")),
        "spec/devices/lid/items.toml:7: INC-R-1 chooses some for topic heartbeat.range, but the shared CO-R-1 "
        "(spec/canopen/shared.toml:7) chooses any; give the same answer, or give the reason in `overrides = …`\n");
    EXPECT_EQ(all_faults(loaded(of_box("any"), of_lid("some", overrides), of_all("any"), "Somebody")), "");
}

TEST(DecisionTopics, ReasonToDifferFromOtherDevicesDoesNotOverrideASharedRequirement) {
    EXPECT_THAT(all_faults(loaded(of_box("any"), of_lid("some", differs), of_all("any"))),
                HasSubstr("INC-R-1 chooses some for topic heartbeat.range, but the shared CO-R-1"));
}

TEST(DecisionTopics, DeviceThatOverridesASharedRequirementMayDifferFromADeviceThatFollowsIt) {
    EXPECT_EQ(all_faults(loaded(of_box("any"), of_lid("some", overrides), of_all("any"))), "");
    EXPECT_THAT(all_faults(loaded(of_box("none", overrides), of_lid("some", overrides), of_all("any"))),
                HasSubstr("INC-R-1 chooses some for topic heartbeat.range, but AO4-R-1"))
        << "two ways to override are no agreement";
}

TEST(DecisionTopics, RetiredRequirementAnswersNoTopic) {
    EXPECT_EQ(all_faults(loaded(of_box("any") + "retired = \"gone\"\n", of_lid("some"), of_all("some"))), "");
}

TEST(DecisionTopics, ChangedAnswerToATopicChangesTheFingerprint) {
    const auto print = [](const std::string& text) {
        return fingerprint(loaded(text, "").content.part("box")->requirements.front());
    };
    EXPECT_NE(print(of_box("any")), print(of_box("some")));
    EXPECT_NE(print(of_box("any")), print(of_box("any", differs)));
    EXPECT_NE(print(of_box("any", differs)), print(of_box("any", overrides)));
}

TEST(DecisionTopics, AnswerAboutAServiceIsComparedWithDeviceToml) {
    const auto service = [](std::string text) {
        return text.replace(text.find("heartbeat.range"), 15, "services.lss");
    };
    EXPECT_EQ(all_faults(loaded(service(of_box("true")), "")), "") << "one answer is enough: device.toml is the other";
    EXPECT_THAT(all_faults(loaded("", service(of_lid("false")))),
                HasSubstr("lid/items.toml:7: INC-R-1 chooses false for topic services.lss, but device.toml has true"));
    EXPECT_THAT(
        all_faults(loaded("", "", service(of_all("true")))),
        HasSubstr("CO-R-1 is a shared item and cannot answer topic services.lss; leave this topic to the devices"));
}

/// The built-in register of the program has no decisions of devices.
TEST(DecisionTopics, SingleAnswerToATopicIsReportedOnlyIfTheRegisterHasDeviceDecisions) {
    EXPECT_EQ(all_faults(loaded(of_box("any", differs), "")), "");
    EXPECT_THAT(all_faults(loaded(of_box("any") + decision_of_box, "")),
                HasSubstr("items.toml:7: no other item answers topic heartbeat.range"));
}

}  // namespace canproof::host::test
