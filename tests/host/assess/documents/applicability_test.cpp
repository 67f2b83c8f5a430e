// SPDX-License-Identifier: Apache-2.0
// Tests that the documents of a device contain only what the device has: shared rules, threats, messages, signals.
#include "host/assess/documents/applicability.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/device_documents.hpp"
#include "host/assess/documents/error_matrix.hpp"
#include "host/assess/documents/failure_modes.hpp"
#include "host/assess/documents/hardware_interface.hpp"
#include "host/assess/documents/interface_control.hpp"
#include "host/assess/documents/residual_errors.hpp"
#include "host/assess/documents/safety_manual.hpp"
#include "host/assess/documents/threats.hpp"
#include "host/base/input_error.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The conditions of the shared items that the fixture SharedItems has.
const char* const conditions = R"([[shared]]
items = ["CO-SDO", "CO-D-PDO"]
[[shared]]
items = ["CO-SYNC"]
objects = ["1005h"]
[[shared]]
items = ["CO-PDO"]
objects = ["1400h-15FFh:05"]
[[shared]]
items = ["CO-D-PDO-002"]
without = ["1400h-15FFh"]
[[shared]]
items = ["CO-LSS"]
lss = true
[[shared]]
items = ["CO-BLOCK"]
block = true
[[shared]]
items = ["CO-ZCAN"]
elsewhere = "another port"
)";

Requirement rule(const char* id, const char* text, const char* kind) {
    Requirement made;
    made.id = id;
    made.text = text;
    made.kind = kind;
    return made;
}

Decision high_decision(const char* id) {
    Decision made;
    made.id = id;
    made.text = "Which?";
    made.severity = "high";
    return made;
}

Object object_at(const std::uint16_t index, const std::vector<std::uint8_t>& subs) {
    Object made;
    made.index = index;
    for (const auto sub : subs) {
        Entry entry;
        entry.subindex = sub;
        made.entries.push_back(entry);
    }
    return made;
}

Signal input(const char* id, const char* name) {
    Signal made;
    made.id = id;
    made.name = name;
    made.input = true;
    made.type = "REAL32";
    made.minimum = 0.0;
    made.maximum = 1.0;
    return made;
}

/// The device `valve` has LSS and an RPDO without an event timer; `gauge` has a SYNC and an RPDO with an event timer.
class SharedItems : public ::testing::Test {
  protected:
    SharedItems() {
        Part rules;
        rules.name = "canopen";
        rules.requirements = {
            rule("CO-SDO-001", "SDO in 1 s.", "timing"),     rule("CO-SYNC-003", "SYNC in 1 s.", "timing"),
            rule("CO-PDO-021", "Event timer.", "timing"),    rule("CO-LSS-014", "Switch delay.", "timing"),
            rule("CO-BLOCK-001", "Block in 1 s.", "timing"), rule("CO-ZCAN-013", "Wait 250 ms.", "timing")};
        rules.decisions = {high_decision("CO-D-PDO-001"), high_decision("CO-D-PDO-002")};
        Part valve;
        valve.name = "valve";
        valve.info.lss = true;
        valve.objects = {object_at(0x1400, {0, 1, 2})};
        valve.requirements = {rule("VA-A-001", "The valve sends.", "fault")};
        valve.signals = {input("VA-S-FLOW", "flow"), input("VA-S-RAIN", "rain")};
        Part gauge;
        gauge.name = "gauge";
        gauge.objects = {object_at(0x1005, {0}), object_at(0x1016, {0, 1}), object_at(0x1401, {0, 1, 2, 5})};
        gauge.requirements = {rule("GA-A-001", "The gauge shows.", "fault")};
        content_.parts = {rules, valve, gauge};
    }

    const Part& valve() const { return content_.parts.at(1); }
    const Part& gauge() const { return content_.parts.at(2); }

    Analysis analysis(const std::string& text) const {
        const auto folder = std::filesystem::path{::testing::TempDir()} / "shared_analysis";
        std::filesystem::create_directories(folder);
        std::ofstream{folder / "a.toml"} << text;
        return read_analysis(folder, content_);
    }
    std::string refusal(const std::string& text) const {
        try {
            analysis(text);
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    }

    /// Returns the first cells of the rows of the table with this caption.
    static std::vector<std::string> column_of(const Document& document, const std::string& caption) {
        std::vector<std::string> cells;
        for (const auto& chapter : document.chapters) {
            for (const auto& table : chapter.tables) {
                for (const auto& row :
                     table.caption == caption ? table.rows : std::vector<std::vector<std::string>>{}) {
                    cells.push_back(row.at(0));
                }
            }
        }
        return cells;
    }
    static std::vector<std::vector<std::string>> rows_of(const Document& document, const std::size_t chapter,
                                                         const std::size_t table) {
        return document.chapters.at(chapter).tables.at(table).rows;
    }

    Register content_;
};

}  // namespace

TEST_F(SharedItems, DeviceListsTheSharedTimingOfItsServicesAndObjectsAlone) {
    const Analysis known = analysis(conditions);
    const std::string caption = "Timing of shared firmware in this device";
    EXPECT_THAT(column_of(interface_control(content_, valve(), known), caption),
                ElementsAre("CO-SDO-001", "CO-LSS-014"));
    EXPECT_THAT(column_of(interface_control(content_, gauge(), known), caption),
                ElementsAre("CO-SDO-001", "CO-SYNC-003", "CO-PDO-021"));
    content_.parts[2].info.block_sdo = true;
    EXPECT_THAT(column_of(interface_control(content_, gauge(), known), caption), Contains("CO-BLOCK-001"));
}

TEST_F(SharedItems, DeviceListsTheSharedDecisionsThatConcernIt) {
    content_.parts[1].objects.clear();
    const Analysis known = analysis(conditions);
    const std::string caption = "Decisions of severity high, or named by a hazard";
    EXPECT_THAT(column_of(safety_manual(content_, valve(), known), caption),
                ElementsAre("CO-D-PDO-001", "CO-D-PDO-002"));
    EXPECT_THAT(column_of(safety_manual(content_, gauge(), known), caption), ElementsAre("CO-D-PDO-001"));
}

TEST_F(SharedItems, ThreatConcernsDevicesByTheirSubIndices) {
    const Analysis known = analysis(std::string{conditions} + R"([[threat]]
service = "RPDO with a timer"
objects = ["1400h-15FFh:05"]
requirement = "FR 7"
text = "Flood."
by = ["CO-PDO-021"]
rest = "Some."
[[threat]]
service = "RPDO without a timer"
objects = ["1400h-15FFh"]
without = ["1400h-15FFh:05"]
requirement = "FR 7"
text = "Flood."
rest = "All."
)");
    EXPECT_THAT(column_of(threats(valve(), known), "Threats"), ElementsAre("RPDO without a timer"));
    EXPECT_THAT(column_of(threats(gauge(), known), "Threats"), ElementsAre("RPDO with a timer"));
}

TEST_F(SharedItems, SharedItemWithoutAConditionIsRefused) {
    content_.parts[0].requirements.push_back(rule("CO-NEW-001", "New.", "protocol"));
    EXPECT_THAT(refusal(conditions), HasSubstr("no [[shared]] of reports/analysis names `CO-NEW-001` or its group"));
    EXPECT_EQ(refusal(""), "");  // an analysis without any condition: every shared item concerns every device
    EXPECT_EQ(refusal(std::string{conditions} + "[[shared]]\nitems = [\"CO-NEW\"]\n"), "");
    content_.parts[0].requirements.pop_back();
    content_.parts[0].decisions.push_back(high_decision("CO-D-NEW-001"));
    EXPECT_THAT(refusal(conditions), HasSubstr("names `CO-D-NEW-001` or its group"));
}

TEST_F(SharedItems, AnalysisThatNamesARequirementOfAnotherDeviceOrServiceIsRefused) {
    const std::string known = conditions;
    const std::string mode = "[[failure_mode]]\ndevices = [\"valve\"]\nat = \"RPDO\"\nmode = \"missing\"\n";
    EXPECT_THAT(refusal(known + mode + "detected = [\"CO-PDO-021\"]\n"),
                HasSubstr("`CO-PDO-021` does not concern valve"));
    EXPECT_THAT(refusal(known + mode + "reaction = [\"GA-A-001\"]\n"), HasSubstr("`GA-A-001` does not concern valve"));
    EXPECT_EQ(refusal(known + mode + "reaction = [\"VA-A-001\", \"CO-LSS-014\"]\n"), "");
    EXPECT_THAT(refusal(known + "[[threat]]\nservice = \"RPDO\"\nobjects = [\"1400h-15FFh\"]\nrequirement = \"FR 7\"\n"
                                "text = \"t\"\nrest = \"r\"\nby = [\"CO-PDO-021\"]\n"),
                HasSubstr("`CO-PDO-021` does not concern valve"));
    EXPECT_THAT(refusal(known + "[[communication_error]]\nerror = \"Loss\"\nby = [\"CO-BLOCK-001\"]\n"),
                HasSubstr("`CO-BLOCK-001` concerns no device"));
    EXPECT_EQ(refusal(known + "[[communication_error]]\nerror = \"Loss\"\nby = [\"CO-PDO-021\"]\n"), "");
}

TEST_F(SharedItems, ConditionThatNamesNoObjectsIsRefused) {
    for (const char* right : {"1010h", "1400h-15FFh", "1400h:05", "1400h-15FFh:05"}) {
        EXPECT_TRUE(names_objects(right)) << right;
    }
    for (const char* wrong :
         {"", "1010", "101h", "10100h", "1400h-", "1400h-15FF", "1400h:5", "1400h:005", "1400h 1401h"}) {
        EXPECT_FALSE(names_objects(wrong)) << wrong;
    }
    EXPECT_THAT(refusal("[[shared]]\nitems = [\"CO-SDO\"]\nwithout = [\"1400\"]\n"),
                HasSubstr("a.toml:1: `1400` names no objects"));
}

TEST_F(SharedItems, DocumentThatNamesASharedItemOfAnotherDeviceIsRefused) {
    const std::string threat = "[[threat]]\nservice = \"NMT\"\nrequirement = \"FR 1\"\ntext = \"Stop.\"\nrest = ";
    EXPECT_NO_THROW(device_documents(content_, valve(), analysis(conditions + threat + "\"See CO-LSS-0140.\"\n")));
    EXPECT_NO_THROW(device_documents(content_, valve(), analysis(conditions + threat + "\"See CO-LSS-014.\"\n")));
    try {
        device_documents(content_, gauge(), analysis(conditions + threat + "\"See CO-LSS-014.\"\n"));
        FAIL() << "the document of the gauge names a requirement of LSS, which the gauge does not have";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the document threats of gauge names CO-LSS-014"));
    }
}

TEST_F(SharedItems, InputOfTheSimulatedWorldHasNoFailureModeAndNoLimit) {
    const Analysis known = analysis("[[simulated]]\ndevice = \"valve\"\nsignals = [\"VA-S-RAIN\"]\n");
    EXPECT_THAT(column_of(failure_modes(content_, valve(), known), "Inputs"),
                ElementsAre("flow (VA-S-FLOW)", "flow (VA-S-FLOW)", "flow (VA-S-FLOW)", "flow (VA-S-FLOW)"));
    EXPECT_THAT(column_of(safety_manual(content_, valve(), known), "Limits of the signals"), ElementsAre("flow"));
    const Document interface = hardware_interface(valve(), known);
    EXPECT_THAT(column_of(interface, "Inputs"), ElementsAre("flow"));
    EXPECT_THAT(column_of(interface, "Inputs of the simulated world"), ElementsAre("rain"));
    EXPECT_THAT(refusal("[[simulated]]\ndevice = \"valve\"\nsignals = [\"VA-S-SUN\"]\n"),
                HasSubstr("valve has no signal `VA-S-SUN`"));
    EXPECT_THAT(refusal("[[simulated]]\ndevice = \"valve\"\nsignals = [\"VA-S-RAIN\"]\n[[failure_mode]]\n"
                        "devices = [\"valve\"]\nsignals = [\"VA-S-RAIN\"]\nmode = \"NaN\"\n"),
                HasSubstr("the signal `VA-S-RAIN` belongs to the simulated world"));
    content_.parts[1].signals[1].input = false;
    EXPECT_THAT(refusal("[[simulated]]\ndevice = \"valve\"\nsignals = [\"VA-S-RAIN\"]\n"),
                HasSubstr("`VA-S-RAIN` is an output"));
}

TEST_F(SharedItems, MessagesOfADeviceIncludeGuardingMonitoredHeartbeatsAndThoseOfTheAnalysis) {
    const Analysis known = analysis(
        "[[message]]\ndevice = \"gauge\"\nmessage = \"NMT start\"\ndirection = \"sent\"\n"
        "cob_id = \"000h\"\nbytes = \"2\"\nobject = \"5555h\"\nby = [\"GA-A-001\"]\n");
    const auto of_gauge = rows_of(interface_control(content_, gauge(), known), 0, 0);
    EXPECT_THAT(of_gauge, Contains(ElementsAre("NMT start (GA-A-001)", "sent", "000h", "2", "5555h")));
    EXPECT_THAT(of_gauge, Contains(ElementsAre("Heartbeat of another node", "received", "700h + node-ID in 1016h", "1",
                                               "1016h")));
    EXPECT_THAT(of_gauge, Contains(ElementsAre("Guarding request", "received", "701h", "remote frame", "")));
    const auto of_valve = rows_of(interface_control(content_, valve(), known), 0, 0);
    EXPECT_THAT(of_valve, Not(Contains(Contains("Heartbeat of another node"))));
    EXPECT_THAT(of_valve, Not(Contains(Contains("NMT start (GA-A-001)"))));
}

TEST_F(SharedItems, BitRatesAreThoseOfTheDataSheetAndOfTheTables) {
    Table switches;
    switches.inputs.resize(1);
    switches.outputs.resize(1);
    switches.outputs[0].name = "bit_rate";
    for (const std::int64_t rate : {666667, 0, 20000}) {
        switches.rows.push_back({{Cell{{{std::int64_t{1}, {}, false}}}, Cell{{{rate, {}, false}}}}, {}});
    }
    content_.parts[1].tables = {switches};
    content_.parts[1].info.bit_rates = {20000, 500000};
    const auto services = rows_of(interface_control(content_, valve(), {}), 1, 0);
    EXPECT_THAT(services, Contains(ElementsAre("Bit rates (bit/s)", "20000, 500000, 666667")));
    EXPECT_THAT(services, Contains(ElementsAre("Event of TPDOs of type 254 and 255", "none: no TPDO")));
    EXPECT_THAT(column_of(residual_errors(content_, {}), "Undetected wrong frames an hour, on a full bus"),
                ElementsAre("20000", "500000", "666667"));
}

}  // namespace canproof::host::test
