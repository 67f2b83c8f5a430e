// SPDX-License-Identifier: Apache-2.0
// Tests the set of conformance cases: it must cover each test number of the public transcript of a CANopen conformance
// run. Each case must name its requirements and risks, and apply to some slave.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "devices/catalogue.hpp"
#include "host/conform/link/virtual_target.hpp"
#include "host/conform/run/case_files.hpp"
#include "host/conform/run/run_cases.hpp"
#include "host/selection/built_in.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/support/every_device.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::host::conform::test {

namespace {

const std::vector<Case>& cases() {
    return built_in_cases().cases;
}

/// Returns the test numbers of the public transcript of a conformance run, by its groups.
std::vector<std::string> public_numbers() {
    struct Row {
        const char* group;
        int first;
        int last;
    };
    const std::vector<Row> rows{{"1", 0, 0}, {"2", 1, 30},    {"3", 1, 33},    {"4", 1, 9},  {"5", 1, 6}, {"6", 1, 10},
                                {"7", 1, 6}, {"7", 101, 107}, {"7", 201, 207}, {"8", 1, 10}, {"9", 1, 4}, {"10", 1, 4}};
    std::vector<std::string> numbers;
    for (const Row& row : rows) {
        for (int number = row.first; number <= row.last; ++number) {
            numbers.push_back(std::string{row.group} + "." + std::to_string(number));
        }
    }
    return numbers;
}

/// Returns the texts of the cases in the files, each from its heading on.
std::vector<std::string> case_texts() {
    std::vector<std::string> texts;
    for (const auto& [path, text] : case_files()) {
        for (std::size_t start = text.find("[["); start != std::string::npos;) {
            const std::size_t end = text.find("\n[[", start);
            const std::string one = text.substr(start, end == std::string::npos ? end : end - start);
            if (one.rfind("[[case]]", 0) == 0) {
                texts.push_back(one);
            }
            start = end == std::string::npos ? end : end + 1;
        }
    }
    return texts;
}

bool has_any(const std::string& text, const std::vector<std::string>& words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

void run_cases_on(std::unique_ptr<SimulatedDevice> device, const ConformSheet& sheet, std::set<std::string>& applied) {
    VirtualTarget target{std::move(device), sheet.node_id};
    const ConformReport report = run_cases(built_in_cases(), sheet, target, {});
    for (const CaseResult& one : report.results) {
        if (one.verdict == Verdict::skipped) {
            EXPECT_FALSE(one.why.empty()) << one.id;
        } else {
            EXPECT_EQ(one.verdict, Verdict::passed)
                << sheet.name << ": " << one.id << ": " << one.why << " " << one.step;
            applied.insert(one.id);
        }
    }
}

Entry entry(std::uint8_t subindex, const char* type, const char* access, std::int64_t value) {
    Entry made;
    made.subindex = subindex;
    made.name = "Entry " + std::to_string(subindex);
    made.type = type;
    made.access = access;
    made.value = value;
    made.stored = made.access == "rw";
    return made;
}

/// Returns an object with the two COB-IDs of an SDO.
Object sdo_parameter(std::uint16_t index, const char* access, std::int64_t to_server, std::int64_t to_client) {
    Object made;
    made.index = index;
    made.name = "SDO parameter " + std::to_string(index);
    made.kind = Object::Kind::record;
    made.entries = {entry(0, "UNSIGNED8", "const", 2), entry(1, "UNSIGNED32", access, to_server),
                    entry(2, "UNSIGNED32", access, to_client)};
    return made;
}

/// Returns the conformance slave with additional objects that none of our devices has. These objects store the written
/// values, but have no effect.
Part slave_with_more_objects() {
    Part part = canproof::test::slave_part();
    Object window;
    window.index = 0x1007;
    window.name = "Synchronous window length";
    window.entries = {entry(0, "UNSIGNED32", "rw", 0)};
    Object server = sdo_parameter(0x1200, "ro", 0x600, 0x580);
    server.entries[1].node_id = true;
    server.entries[2].node_id = true;
    for (const Object& more : {window, server, sdo_parameter(0x1201, "rw", 0x80000000, 0x80000000),
                               sdo_parameter(0x1280, "rw", 0x80000000, 0x80000000)}) {
        part.objects.push_back(more);
    }
    std::sort(part.objects.begin(), part.objects.end(),
              [](const Object& a, const Object& b) { return a.index < b.index; });
    return part;
}

/// Returns the conformance slave with its heartbeat on by default, which excludes guarding.
Part slave_with_heartbeat() {
    Part part = canproof::test::slave_part();
    for (Object& one : part.objects) {
        if (one.index == 0x1017) {
            one.entries.front().value = 1000;
        }
    }
    return part;
}

}  // namespace

TEST(ConformCases, EachTestNumberOfThePublicConformanceTranscriptIsInExactlyOneCase) {
    std::map<std::string, int> found;
    for (const Case& one : cases()) {
        for (const std::string& number : one.numbers) {
            ++found[number];
        }
    }
    const std::vector<std::string> wanted = public_numbers();
    ASSERT_EQ(wanted.size(), 127U);
    for (const std::string& number : wanted) {
        EXPECT_EQ(found[number], 1) << number;
    }
    EXPECT_EQ(found.size(), wanted.size()) << "a number that the transcript does not have";
}

TEST(ConformCases, AtLeast100CasesAreNotInThePublicConformanceTranscript) {
    const auto own = std::count_if(cases().begin(), cases().end(), [](const Case& one) { return one.numbers.empty(); });
    EXPECT_GE(own, 100);
    EXPECT_GE(cases().size(), 227U);
}

TEST(ConformCases, CasesHaveUniqueIds) {
    std::set<std::string> ids;
    for (const Case& one : cases()) {
        EXPECT_TRUE(ids.insert(one.id).second) << one.id;
        EXPECT_FALSE(one.shows.empty()) << one.id;
        EXPECT_EQ(one.section.rfind("CiA 30", 0), 0U) << one.id << ": " << one.section;
    }
}

TEST(ConformCases, CasesNameOnlyRequirementsThatAreNotRetired) {
    std::set<std::string> ids;
    for (const Requirement& one : built_in_register().part("canopen")->requirements) {
        if (one.retired.empty()) {
            ids.insert(one.id);
        }
    }
    for (const Case& one : cases()) {
        for (const std::string& id : one.tests) {
            EXPECT_EQ(ids.count(id), 1U) << one.id << ": " << id;
        }
    }
}

// The runner skips a case that declares a risk, unless the user permits this risk.
TEST(ConformCases, CasesDeclareTheirRisksForTheEquipment) {
    const std::vector<std::string> texts = case_texts();
    ASSERT_EQ(texts.size(), cases().size());
    for (const std::string& text : texts) {
        if (has_any(text, {"nmt start", "send 080"})) {
            EXPECT_TRUE(has_any(text, {"\nrisk = "})) << "may move an output: " << text;
        }
        if (has_any(text, {"write 1010:01 = \"save\"", "write 1010:02 = \"save\"", "write 1011:01 = \"load\""})) {
            EXPECT_TRUE(has_any(text, {"\nrisk = \"store\""})) << text;
        }
        if (has_any(text, {"lss select", "lss configuration", "send 7E5"})) {
            EXPECT_TRUE(has_any(text, {"\nrisk = \"lss\""})) << text;
        }
    }
}

TEST(ConformCases, CasesPassOnEachSlave_AndAllButOneCaseApplyToSomeSlave) {
    std::set<std::string> applied;
    for (const std::string& name : canproof::test::every_device()) {
        run_cases_on(make_device(name), sheet_of(built_in_register(), device_named(name)), applied);
    }
    for (const Part& part : {canproof::test::slave_part(), slave_with_more_objects(), slave_with_heartbeat()}) {
        run_cases_on(std::make_unique<GenericSimulation>(part), sheet_of(part), applied);
    }
    const std::set<std::string> unseen{"dictionary-structure"};  // none of our slaves answers sub-index FFh
    for (const Case& one : cases()) {
        EXPECT_EQ(applied.count(one.id), unseen.count(one.id) == 0 ? 1U : 0U) << one.id;
    }
}

}  // namespace canproof::host::conform::test
