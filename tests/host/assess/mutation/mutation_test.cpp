// SPDX-License-Identifier: Apache-2.0
// Tests mutation: the alterations that are generated for each cell (a value in a generated table), the sample that is
// drawn from them, and the records of alterations that may survive.
#include "host/assess/mutation/mutation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "host/assess/mutation/code_exhibit.hpp"
#include "host/assess/mutation/code_mutation.hpp"
#include "host/assess/mutation/killer_log.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/mutation_table.hpp"
#include "host/assess/mutation/survivor_records.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"
#include "host/codegen/cpp_text.hpp"
#include "host/codegen/write_alterations.hpp"
#include "host/codegen/write_objects.hpp"
#include "host/register/alter_value.hpp"
#include "host/register/load.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

const std::string object = R"(
[[object]]
index = 0x2000
name = "Limit"
type = "UNSIGNED8"
access = "rw"
default = 5
range = { min = 0, max = 9 }
mapping = "tpdo"
source = ["M1:1"]
)";

std::string alterations_of(const std::string& text) {
    const LoadResult loaded = load_register(with(items_file, text));
    return write_alterations(loaded.content);
}

std::vector<AlteredCell> cells(std::size_t count) {
    std::vector<AlteredCell> all;
    for (std::size_t i = 0; i < count; ++i) {
        all.push_back({i, "AO4-R-1", "value", "0 -> 1"});
    }
    return all;
}

std::vector<std::size_t> numbers(const std::vector<AlteredCell>& all) {
    std::vector<std::size_t> out;
    for (const auto& cell : all) {
        out.push_back(cell.number);
    }
    return out;
}

class RecordFile {
  public:
    explicit RecordFile(const std::string& text)
        : path_{std::filesystem::temp_directory_path() / ("canproof-records-" + std::to_string(getpid()) + ".toml")} {
        std::ofstream{path_} << text;
    }
    RecordFile(const RecordFile&) = delete;
    RecordFile& operator=(const RecordFile&) = delete;
    ~RecordFile() { std::filesystem::remove(path_); }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace

TEST(Alterations, MutantsOfAnObjectAlterItsDefaultItsLimitsItsAccessAndItsMapping) {
    const std::string text = alterations_of(object);
    for (
        const char* line :
        {R"("AO4-OD-2000", "index", "2000h is missing", &box::object_rows[0U].index)",
         R"("sub 0 default", "5 -> 6", &box::default_image[0U], 1U, 0x6U)",
         R"("sub 0 minimum", "0 -> 1", &box::limit_rows[0U].minimum.bits)",
         R"("sub 0 maximum", "9 -> 10", &box::limit_rows[0U].maximum.bits)",
         R"("sub 0 maximum", "9 -> 8", &box::limit_rows[0U].maximum.bits)",
         R"("sub 0 type", "05h -> 02h", &box::entry_rows[0U].type)",
         // The rights are read 01h + write 02h + TPDO 08h + stored 10h = 1Bh; each alteration flips one bit.
         R"("sub 0 writable", "yes -> no", &box::entry_rows[0U].rights, sizeof(box::entry_rows[0U].rights), 0x19U)",
         R"("sub 0 TPDO mapping", "yes -> no", &box::entry_rows[0U].rights, sizeof(box::entry_rows[0U].rights), 0x13U)",
         R"("sub 0 RPDO mapping", "no -> yes", &box::entry_rows[0U].rights, sizeof(box::entry_rows[0U].rights), 0x1FU)"}) {
        EXPECT_THAT(text, HasSubstr(line));
    }
    EXPECT_THAT(text, Not(HasSubstr("0 -> -1"))) << "an UNSIGNED8 has no value below";
}

TEST(Alterations, MutantsOfATableAlterEachOfItsCells) {
    const std::string text = alterations_of(
        "[[table]]\nid = \"AO4-T-1\"\ntitle = \"x\"\nsource = [\"M1:Table 3\"]\ninputs = [ { name = \"n\", min = 0, "
        "max = 9 } ]\n"
        "outputs = [\"word\", { name = \"gain\", type = \"REAL32\" }]\nrows = [ [\"0..4\", \"low\", 2.0], [\"5..9\", "
        "\"high\", 0.0] ]\n");
    for (const char* line :
         {R"("row 1 n_last", "4 -> 5", &box::x::rows[0U].n_last)", R"("row 1 word", "low -> high")",
          R"("row 2 word", "high -> low")", R"(static_cast<std::uint64_t>(box::x::Word::high))",
          // 2.02F is 400147AEh
          R"("row 1 gain", "2 -> 2.02", &box::x::rows[0U].gain, sizeof(box::x::rows[0U].gain), 0x400147AEU)",
          R"("row 2 gain", "0 -> 0.01")"}) {
        EXPECT_THAT(text, HasSubstr(line));
    }
}

TEST(Alterations, CompiledInConstantsHaveNoMutants) {
    const std::string constant =
        "[[constant]]\nid = \"AO4-K-1\"\nname = \"steps\"\nvalue = 255\ntype = \"UNSIGNED8\"\nsource = [\"M1:1\"]\n";
    EXPECT_THAT(alterations_of(constant),
                HasSubstr(R"("value", "255 -> 254", &box::steps, sizeof(box::steps), 0xFEU)"));
    EXPECT_THAT(alterations_of(constant + "compiled_in = true\n"), Not(HasSubstr("box::steps")));
}

TEST(Alterations, MutationBuildGeneratesTablesThatCanChangeAtRunTime) {
    const LoadResult loaded = load_register(with(items_file, object));
    const Part& box = *loaded.content.part("box");
    EXPECT_THAT(write_objects(box, Cells::changeable), HasSubstr("inline std::array<EntryRow, 1U> entry_rows"));
    EXPECT_THAT(write_objects(box, Cells::constant), HasSubstr("inline constexpr std::array<EntryRow, 1U> entry_rows"));
}

TEST(Alterations, MutationBuildGivesEachEntryItsOwnLimitRow) {
    const std::string two = object +
                            "[[object]]\nindex = 0x2001\nname = \"Other\"\ntype = \"UNSIGNED8\"\naccess = \"rw\"\n"
                            "default = 5\nrange = { min = 0, max = 9 }\nsource = [\"M1:1\"]\n";
    const LoadResult loaded = load_register(with(items_file, two));
    const Part& box = *loaded.content.part("box");
    EXPECT_THAT(write_objects(box, Cells::constant), HasSubstr("std::array<LimitRow, 1U>"));
    EXPECT_THAT(write_objects(box, Cells::changeable), HasSubstr("std::array<LimitRow, 2U>"));
}

TEST(Sample, SameSeedSelectsTheSameSampleOfMutants) {
    const auto all = cells(100);
    const auto first = numbers(sample_of(all, 10, 1));
    EXPECT_EQ(first.size(), 10U);
    EXPECT_EQ(first, numbers(sample_of(all, 10, 1)));
    EXPECT_NE(first, numbers(sample_of(all, 10, 2)));
    EXPECT_EQ(numbers(sample_of(all, 200, 1)), numbers(all)) << "no more than there are";
}

TEST(SelectionOfTests, SelectionHasTheQuickestTestFirstAndTheTimeOfAllTests) {
    Evidence evidence;
    evidence.verdicts["A"] = {{"S.Slow", "test", true, 2.0}, {"S.Quick", "test", true, 0.1}};
    const TestSelection tests = tests_by_item(evidence).at("A");
    EXPECT_EQ(tests.filter, "S.Quick:S.Slow");
    EXPECT_DOUBLE_EQ(tests.unaltered, 2.1);
}

TEST(Records, RecordedReasonJustifiesASurvivingMutant_AndUnusedRecordsAreReported) {
    std::vector<MutationOutcome> outcomes(3);
    outcomes[0].cell = {0, "AO4-OD-2000", "sub 0 default", "5 -> 6"};
    outcomes[1].cell = {1, "AO4-OD-2000", "sub 0 stored", "no -> yes"};
    outcomes[2].cell = {2, "AO4-OD-3000", "sub 0 stored", "no -> yes"};
    outcomes[2].killed_by = "S.T";
    const std::vector<SurvivorRecord> records{{"AO4-OD-2???", "sub * stored", "*", "a reason", 1},
                                              {"AO4-OD-3000", "*", "*", "another", 5}};
    const auto idle = justify(outcomes, records);
    EXPECT_TRUE(outcomes[0].open());
    EXPECT_FALSE(outcomes[1].open());
    EXPECT_FALSE(outcomes[2].open());
    ASSERT_EQ(idle.size(), 1U);
    EXPECT_EQ(idle[0]->line, 5U);
}

TEST(Records, RecordOfASurvivorThatMatchesNoMutantIsReported) {
    const std::vector<SurvivorRecord> records{{"src/a.cpp", "f, line *", "x -> true", "a reason", 1},
                                              {"src/a.cpp", "g, line *", "x -> true", "another", 5}};
    const auto idle = without_alteration(records, {{0, "src/a.cpp", "f, line 7", "x -> true"}});
    ASSERT_EQ(idle.size(), 1U);
    EXPECT_EQ(idle[0]->line, 5U);
}

TEST(Records, RecordOfASurvivingMutantWithoutAReasonIsRefused) {
    const RecordFile file{"[[survivor]]\nitem = \"A\"\ncell = \"*\"\nchange = \"*\"\n"};
    try {
        read_survivor_records(file.path());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(".toml:1: reason is missing"));
    }
}

TEST(Patterns, StarMatchesAnyTextAndQuestionMarkOneCharacter) {
    EXPECT_TRUE(matches("sub * stored", "sub 12 stored"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("a*b*c", "aXbYbZc"));
    EXPECT_FALSE(matches("a?c", "ac"));
    EXPECT_FALSE(matches("sub * stored", "sub 12 stored yes"));
}

TEST(MutationReport, MutationReportIsReadBackByItem) {
    std::vector<MutationOutcome> outcomes(2);
    outcomes[0].cell = {0, "A", "value", "0 -> 1"};
    outcomes[0].killed_by = "S.T";
    outcomes[1].cell = {1, "A", "value", "0 -> 2"};
    const RecordFile file{write_mutation_json(outcomes)};
    const auto counts = read_mutation_json(file.path());
    EXPECT_EQ(counts.at("A").altered, 2U);
    EXPECT_EQ(counts.at("A").noticed, 1U);
    EXPECT_TRUE(read_mutation_json("/nowhere/mutation.json").empty());
}

TEST(CodeMutation, EachTestIsReadWithTheMutantsThatItReaches) {
    const RecordFile file{"Suite.First\ttests/a_test.cpp\t0.250\t0\t7\nSuite.Second\tb\t0.001\n"};
    const auto tests = read_told(file.path());
    ASSERT_EQ(tests.size(), 2U);
    EXPECT_EQ(tests[0].name, "Suite.First");
    EXPECT_EQ(tests[0].file, "tests/a_test.cpp");
    EXPECT_EQ(tests[0].seconds, 0.25);
    EXPECT_EQ(tests[0].mutants, (std::vector<std::size_t>{0, 7}));
    EXPECT_TRUE(tests[1].mutants.empty());
    EXPECT_THROW(read_told("/nowhere/told.tsv"), InputError);
}

TEST(CodeMutation, MutantsReachedAtProgramStartAreListedApartFromThoseOfTests) {
    std::vector<ToldTest> tests{{"startup", 0.0, {1, 9}}, {"S.One", 0.5, {0}}};
    EXPECT_EQ(told_at_startup(tests, 3), (std::vector<bool>{false, true, false}));
    ASSERT_EQ(tests.size(), 1U);
    EXPECT_EQ(tests[0].name, "S.One");
}

TEST(CodeMutation, QuickTestsRunFirstWithinTheTimeBudget) {
    const std::vector<ToldTest> tests{
        {"S.Slow", 5.0, {0, 1}}, {"S.Quick", 0.5, {0}}, {"S.Middling", 1.0, {0}}, {"S.Other", 1.0, {0}}};
    const auto chosen = tests_by_mutant(tests, 3, 2.0);
    EXPECT_EQ(filter_of(tests, chosen[0]), "S.Quick:S.Middling");
    EXPECT_EQ(filter_of(tests, chosen[1]), "S.Slow");
    EXPECT_EQ(filter_of(tests, chosen[2]), "");
}

TEST(CodeMutation, ProgramThatStartsWithAMutantRunsTheQuickestTestsFirst) {
    const std::vector<ToldTest> tests{{"S.Slow", 140.0, {}}, {"S.Quick", 0.5, {}}, {"S.Middling", 1.0, {}}};
    const StartedTests started = tests_of_a_start(tests, 2.0);
    EXPECT_EQ(started.quickest.filter, "S.Quick:S.Middling");
    EXPECT_DOUBLE_EQ(started.quickest.unaltered, 1.5);
    EXPECT_EQ(started.all.filter, "*");
    EXPECT_DOUBLE_EQ(started.all.unaltered, 141.5);
}

TEST(CodeMutation, TestsWithAMutantMayTakeFiveTimesTheirTimeWithout) {
    // 5 × 141.5 s = 707,500 ms; a forked copy may take 500 ms more, and a program that starts 2,000 ms.
    EXPECT_EQ((TestSelection{"*", 141.5}.limit()), 708'000U);
    EXPECT_EQ((TestSelection{"*", 141.5}.limit_with_start()), 709'500U);
    EXPECT_EQ((TestSelection{"S.Quick", 0.0}.limit()), 500U);
    EXPECT_EQ((TestSelection{"S.Quick", 0.0}.limit_with_start()), 2000U);
}

TEST(CodeMutation, ProgramThatStartsWithAMutantGetsTheTimeOfItsTests) {
    const RecordFile script{
        "#!/bin/sh\nread -r flag <\"${2#--gtest_flagfile=}\"\n"
        "[ \"$CANPROOF_ALTER $CANPROOF_ALTER_MILLISECONDS $flag\" = \"3 52000 --gtest_filter=S.Slow\" ]\n"};
    std::filesystem::permissions(script.path(), std::filesystem::perms::owner_all);
    const TestSelection tests{"S.Slow", 10.0};
    ASSERT_EQ(tests.limit_with_start(), 52'000U);
    EXPECT_FALSE(fails_when_started_altered(script.path(), 3, tests)) << "exit status 0 means that all tests passed";
    EXPECT_TRUE(fails_when_started_altered(script.path(), 4, tests));
}

TEST(CodeMutation, ProgramThatStartsWithAMutantTakesAFilterOfAnyLength) {
    const std::size_t length = 300'000;  // Linux permits 131,072 bytes for one argument
    const RecordFile script{"#!/bin/sh\n[ \"$(wc -c <\"${2#--gtest_flagfile=}\")\" -eq 300016 ]\n"};
    std::filesystem::permissions(script.path(), std::filesystem::perms::owner_all);
    // "--gtest_filter=" has 15 bytes, the line break one.
    EXPECT_FALSE(fails_when_started_altered(script.path(), 3, {std::string(length, 'a'), 1.0}));
}

TEST(CodeMutation, KillingTestsAreRememberedWhenTheLineOfAMutantChanges) {
    const RecordFile file{
        "src/a.cpp\tf, line 1\ta < b -> <=\tS.One\nsrc/a.cpp\tf, line 9\ta < b -> <=\tS.Two\n"
        "src/a.cpp\tf, line 3\tx -> true\tsignal 27\nsrc/a.cpp\tf, line 4\ty -> true\t\n"};
    {
        KillerLog log{file.path()};
        EXPECT_EQ(log.filter({0, "src/a.cpp", "f, line 2", "a < b -> <="}), "S.One:S.Two");
        EXPECT_EQ(log.filter({1, "src/a.cpp", "g, line 2", "a < b -> <="}), "");
        EXPECT_EQ(log.filter({2, "src/a.cpp", "f, line 3", "x -> true"}), "") << "no test can be asked first";
        EXPECT_EQ(log.filter({3, "src/a.cpp", "f, line 4", "y -> true"}), "");
        log.note({{3, "src/a.cpp", "f, line 4", "y -> true"}, "S.Three", true, nullptr, ""});
    }
    EXPECT_EQ(KillerLog{file.path()}.filter({0, "src/a.cpp", "f, line 7", "y -> true"}), "S.Three");
}

TEST(CodeMutation, MutationOperatorIsDerivedFromTheChange) {
    const std::vector<std::pair<const char*, const char*>> changes{
        {"a < b -> <=", "condition"},    {"a -> b -> true", "condition"},      {"a + b -> -", "operator"},
        {"x += 1U -> -=", "operator"},   {"f(); -> deleted", "statement"},     {"a = b -> dropped", "assignment"},
        {"a -> variable b", "variable"}, {"list[at] -> [0]", "index"},         {"5U -> +1", "literal"},
        {"5U -> -1", "literal"},         {"f() -> swapped with g()", "order"}, {"a && b -> ||", "condition"}};
    for (const auto& [change, name] : changes) {
        EXPECT_EQ(operator_of(change), name) << change;
    }
}

TEST(CodeMutation, KilledMutantsAreCountedByCodeLayerOperatorAndKindOfTest) {
    const std::vector<MutationOutcome> outcomes{
        {{0, "src/firmware/canopen/nmt.cpp", "f, line 1", "f(); -> deleted"},
         "S.A",
         true,
         nullptr,
         "tests/conformance/a.cpp"},
        {{1, "src/firmware/canopen/nmt.cpp", "f, line 2", "g(); -> deleted"}, "S.B", true, nullptr, "properties/b.cpp"},
        {{2, "src/devices/one/firmware/d.cpp", "f, line 2", "g(); -> deleted"},
         "S.C",
         true,
         nullptr,
         "tests/devices/c.cpp"},
        {{3, "src/devices/one/firmware/d.cpp", "f, line 2", "1U -> +1"}, "signal 27", true, nullptr, ""},
        {{4, "src/devices/one/firmware/d.cpp", "f, line 2", "2U -> +1"}, "", true, nullptr, ""}};
    EXPECT_EQ(operators_csv(outcomes),
              "layer,operator,mutants,conformance,units,properties,otherwise,with a reason,open\r\n"
              "all,all,5,1,1,1,1,0,1\r\nall,literal,2,0,0,0,1,0,1\r\nall,statement,3,1,1,1,0,0,0\r\n"
              "canopen,all,2,1,0,1,0,0,0\r\ncanopen,statement,2,1,0,1,0,0,0\r\n"
              "one,all,3,0,1,0,1,0,1\r\none,literal,2,0,0,0,1,0,1\r\none,statement,1,0,1,0,0,0,0\r\n");
}

TEST(CodeMutation, MutantsOfHostCodeAreCountedSeparatelyInTableAndEvidence) {
    EXPECT_EQ(layer_of("src/host/sim/bus/candump.cpp"), "host/bus");
    EXPECT_EQ(layer_of("src/target/zynqmp/can.cpp"), "target/zynqmp");
    EXPECT_EQ(layer_of("src/host/sim/replay/replay.cpp"), "host/replay");
    EXPECT_TRUE(is_host("src/host/sim/bus/candump.cpp"));
    EXPECT_FALSE(is_host("src/firmware/canopen/node.cpp"));
    const std::vector<MutationOutcome> outcomes{
        {{0, "src/firmware/canopen/a.cpp", "f, line 1", "x -> true"}, "S.T", true, nullptr, "tests/x_test.cpp"},
        {{1, "src/host/sim/bus/b.cpp", "f, line 1", "x -> true"}, "S.T", true, nullptr, "properties/host/x.cpp"},
        {{2, "src/host/sim/bus/b.cpp", "f, line 1", "x -> false"}, "S.T", true, nullptr, "tests/x_test.cpp"},
        {{3, "src/host/sim/replay/c.cpp", "f, line 1", "x -> true"}, "", true, nullptr, ""}};
    const std::string table = operators_csv(outcomes);
    EXPECT_THAT(table, HasSubstr("all,all,1,0,1,0,0,0,0\r\n"));
    EXPECT_THAT(table, HasSubstr("host,all,3,0,1,1,0,0,1\r\n"));
    EXPECT_THAT(table, HasSubstr("host/bus,all,2,0,1,1,0,0,0\r\n"));
    EXPECT_THAT(table, HasSubstr("host/replay,all,1,0,0,0,0,0,1\r\n"));
    const std::string exhibit = code_exhibit(outcomes).at("exhibit.json");
    EXPECT_THAT(exhibit, HasSubstr("1 mutants of the firmware, 100.0 % noticed by a test; 0 survive without a reason. "
                                   "3 mutants of the host's buses and replay, 66.7 % noticed by a test; 1 survive"));
    EXPECT_THAT(exhibit, HasSubstr(R"("state": "open")"));
    EXPECT_THAT(exhibit, HasSubstr(R"("mutants": 1)"));
    EXPECT_THAT(exhibit, HasSubstr(R"("mutants of the host": 3)"));
    EXPECT_EQ(total_of(count_by_item(outcomes), true).altered, 3U);
    EXPECT_EQ(total_of(count_by_item(outcomes), false).altered, 1U);
    EXPECT_DOUBLE_EQ(MutationCount{}.share_noticed(), 100.0);
}

TEST(CodeMutation, EvidenceListsTheSurvivingMutants) {
    const SurvivorRecord record{"src/a.cpp", "f, line 3", "x -> true", "the same either way", 1};
    std::vector<MutationOutcome> outcomes{
        {{0, "src/a.cpp", "f, line 1", "a < b -> <="}, "S.T", true, nullptr, "tests/conformance/nmt_test.cpp"},
        {{1, "src/a.cpp", "f, line 2", "a, b -> false"}, "", true, nullptr, ""},
        {{2, "src/a.cpp", "f, line 3", "x -> true"}, "", true, &record, ""}};
    auto files = code_exhibit(outcomes);
    EXPECT_THAT(files.at("exhibit.json"), HasSubstr(R"("state": "open")"));
    EXPECT_THAT(files.at("exhibit.json"), HasSubstr("3 mutants of the firmware, 33.3 % noticed by a test; 1 survive"));
    EXPECT_EQ(files.at("survivors.csv"),
              "file,place,change,reason\r\nsrc/a.cpp,\"f, line 2\",\"a, b -> false\",open\r\n"
              "src/a.cpp,\"f, line 3\",x -> true,the same either way\r\n");
    EXPECT_THAT(files.at("operators.csv"), HasSubstr("all,all,3,1,0,0,0,1,1\r\n"));
    EXPECT_EQ(files.at("files.csv"), "file,altered,noticed,with a reason\r\nsrc/a.cpp,3,1,1\r\n");
    outcomes.erase(outcomes.begin() + 1);
    EXPECT_THAT(code_exhibit(outcomes).at("exhibit.json"), HasSubstr(R"("state": "holds")"));
}

}  // namespace canproof::host::test
