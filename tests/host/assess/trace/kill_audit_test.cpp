// SPDX-License-Identifier: Apache-2.0
// Tests reports/kills.csv, which lists the tests that notice a mutant of the items they name in verifies<>. Also tests
// the messages of the audit when a test was removed or changed.
#include "host/assess/trace/kill_audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "host/assess/source/test_bodies.hpp"
#include "host/assess/trace/kill_record.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string source_text = R"(// Tests.
TEST_F(Relay, Closes) {
    verifies<req::A>();
    EXPECT_EQ(state(), "{");  // on
}
TEST_P(Relay, OpensAtEachDelay) {
    EXPECT_TRUE(open(1'000));
}
RC_GTEST_PROP(RelayLaw, EveryValueEqualsItself, (const int value)) {
    RC_ASSERT(value == value);
}
)";

class Kills : public testing::Test {
  protected:
    Kills() : root_{std::filesystem::temp_directory_path() / ("canproof-kills-" + std::to_string(getpid()))} {
        std::filesystem::create_directories(root_ / "tests");
        write(source_text);
        for (const char* test : {"Relay.Closes", "All/Relay.OpensAtEachDelay/0", "RelayLaw.EveryValueEqualsItself"}) {
            evidence_.runs.push_back({test, "tests/relay_test.cpp", true, true});
            record_[test] = {hash(test), {}, {}};
        }
        claim("A", "Relay.Closes");
        claim("B", "All/Relay.OpensAtEachDelay/0");
        claim("C", "RelayLaw.EveryValueEqualsItself");
        for (auto& [test, line] : record_) {
            line.code = code_by_test(evidence_).at(test);
        }
        record_["Relay.Closes"].kills = {"A"};
        record_["RelayLaw.EveryValueEqualsItself"].without_mutants = {"C"};
    }
    ~Kills() override { std::filesystem::remove_all(root_); }

    void write(const std::string& text) const { std::ofstream{root_ / "tests" / "relay_test.cpp"} << text; }
    std::string hash(const std::string& test) const { return TestBodies{root_}.hash("tests/relay_test.cpp", test); }
    void claim(const std::string& id, const std::string& test) {
        evidence_.verdicts[id].push_back({test, "test", true, 0.0, "tests/relay_test.cpp"});
    }
    KillAudit audit() const { return audit_kills({"A", "B", "C"}, evidence_, record_, root_); }
    static std::string edited(const std::string& from, const std::string& to) {
        std::string text = source_text;
        return text.replace(text.find(from), from.size(), to);
    }

    std::filesystem::path root_;
    Evidence evidence_;
    KillRecord record_;
};

}  // namespace

TEST_F(Kills, ItemCountsAsCheckedWhenATestNoticesOneOfItsMutants) {
    const KillAudit found = audit();
    EXPECT_EQ(found.shown, 1U);
    EXPECT_THAT(found.unnoticed, ElementsAre("B"));
    EXPECT_THAT(found.immutable, ElementsAre("C"));
    EXPECT_THAT(found.idle, ElementsAre("All/Relay.OpensAtEachDelay/0", "RelayLaw.EveryValueEqualsItself"));
    EXPECT_THAT(found.unjudged, IsEmpty());
    EXPECT_THAT(found.regressions, IsEmpty());
}

TEST_F(Kills, RemovedTestIsARegression) {
    evidence_.runs.erase(evidence_.runs.begin());
    evidence_.verdicts.erase("A");
    const KillAudit found = audit();
    EXPECT_EQ(found.shown, 0U);
    EXPECT_THAT(found.regressions,
                ElementsAre("A: Relay.Closes noticed a mutant of this item, but no test in its present form does",
                            "Relay.Closes: the test no longer exists; it noticed mutants of A"));
}

TEST_F(Kills, RemovedTestIsReportedDespiteAnotherTestOfTheItem) {
    evidence_.runs.erase(evidence_.runs.begin());
    evidence_.verdicts.erase("A");
    claim("A", "RelayLaw.EveryValueEqualsItself");
    record_["RelayLaw.EveryValueEqualsItself"].kills = {"A"};
    record_["RelayLaw.EveryValueEqualsItself"].code = code_by_test(evidence_).at("RelayLaw.EveryValueEqualsItself");
    const KillAudit found = audit();
    EXPECT_EQ(found.shown, 1U);
    EXPECT_THAT(found.regressions, ElementsAre("Relay.Closes: the test no longer exists; it noticed mutants of A"));
}

TEST_F(Kills, TestThatHasLostItsAssertionsIsARegression) {
    write(edited("EXPECT_EQ(state(), \"{\");", ""));
    const KillAudit found = audit();
    EXPECT_EQ(found.shown, 0U);
    EXPECT_THAT(found.changed, ElementsAre("Relay.Closes"));
    EXPECT_THAT(found.unjudged, ElementsAre("A"));
    EXPECT_THAT(found.regressions,
                ElementsAre("A: Relay.Closes noticed a mutant of this item, but no test in its present form does"));
}

TEST_F(Kills, NewTestIsListedAsNotYetRunOnMutants) {
    evidence_.runs.push_back({"Relay.IsNew", "tests/relay_test.cpp", true, true});
    evidence_.verdicts.erase("B");
    claim("B", "Relay.IsNew");
    const KillAudit found = audit();
    EXPECT_THAT(found.never, ElementsAre("Relay.IsNew"));
    EXPECT_THAT(found.unjudged, ElementsAre("B"));
    EXPECT_THAT(kill_summary(found), HasSubstr("1 item(s) have a mutant that a test notices, 0 have only mutants that "
                                               "no test notices, 1 have no mutants, 1 wait"));
}

TEST_F(Kills, CommentsAndLayoutDoNotChangeTheBodyHash) {
    const std::string before = hash("Relay.Closes");
    EXPECT_EQ(before.size(), 16U);
    write(edited("// on", "// closed") + "TEST(Other, Test) {}\n");
    EXPECT_EQ(hash("Relay.Closes"), before);
    write(edited("EXPECT_EQ(state(), \"{\");", "EXPECT_EQ(\n        state(),  \"{\");"));
    EXPECT_EQ(hash("Relay.Closes"), before);
    write(edited("\"{\"", "\" {\""));
    EXPECT_NE(hash("Relay.Closes"), before);
}

TEST_F(Kills, EachTestHasItsOwnBodyHash) {
    const std::string law = hash("RelayLaw.EveryValueEqualsItself");
    write(edited("1'000", "1'001"));
    EXPECT_NE(hash("All/Relay.OpensAtEachDelay/0"), record_["All/Relay.OpensAtEachDelay/0"].body);
    EXPECT_EQ(hash("RelayLaw.EveryValueEqualsItself"), law);
    EXPECT_EQ(hash("Relay.Missing"), "");
    EXPECT_EQ(TestBodies{root_}.hash("tests/none.cpp", "Relay.Closes"), "");
}

TEST_F(Kills, RecordOfKilledMutantsIsReadBackAsWritten) {
    record_["Relay.Closes"].kills = {"A", "B"};
    const std::string text = write_kill_record(record_);
    const KillLine& line = record_["Relay.Closes"];
    EXPECT_THAT(text, HasSubstr("\nRelay.Closes," + line.body + ",A B,," + line.code + "\n"));
    std::ofstream{root_ / "kills.csv"} << text;
    const KillRecord read = read_kill_record(root_ / "kills.csv");
    EXPECT_EQ(write_kill_record(read), text);
    EXPECT_THAT(read.at("RelayLaw.EveryValueEqualsItself").without_mutants, ElementsAre("C"));
    EXPECT_TRUE(read_kill_record(root_ / "none.csv").empty());
    std::ofstream{root_ / "kills.csv"} << "test,body,kills,without mutants,code\nRelay.Closes\n";
    EXPECT_THROW(read_kill_record(root_ / "kills.csv"), InputError);
    std::ofstream{root_ / "kills.csv"} << "test,body,kills,without mutants,code\nRelay.Closes,1,A,,2,3\n";
    EXPECT_THROW(read_kill_record(root_ / "kills.csv"), InputError);
}

TEST_F(Kills, LineOfAnOlderKillRecordHasNoCodeHash) {
    std::ofstream{root_ / "kills.csv"} << "test,body,kills,without mutants\nRelay.Closes,1234,A B,C\n";
    const KillLine line = read_kill_record(root_ / "kills.csv").at("Relay.Closes");
    EXPECT_EQ(line.body, "1234");
    EXPECT_THAT(line.kills, ElementsAre("A", "B"));
    EXPECT_THAT(line.without_mutants, ElementsAre("C"));
    EXPECT_EQ(line.code, "");
}

TEST_F(Kills, TestOfChangedCodeMustRunOnMutantsAgainAndIsNoRegression) {
    evidence_.work["A"].code = "12345678";
    const KillAudit found = audit();
    EXPECT_EQ(found.shown, 0U);
    EXPECT_THAT(found.unjudged, ElementsAre("A"));
    EXPECT_THAT(found.other_code, ElementsAre("Relay.Closes"));
    EXPECT_THAT(found.changed, IsEmpty());
    EXPECT_THAT(found.regressions, IsEmpty());
    EXPECT_THAT(kill_summary(found),
                HasSubstr("tests whose items have other code than in the last mutation run: Relay.Closes\n"));
    record_["Relay.Closes"].code = code_by_test(evidence_).at("Relay.Closes");
    EXPECT_EQ(audit().shown, 1U);
}

TEST_F(Kills, ChangedCodeDoesNotHideAChangedTest) {
    evidence_.work["A"].code = "12345678";
    write(edited("EXPECT_EQ(state(), \"{\");", ""));
    const KillAudit found = audit();
    EXPECT_THAT(found.changed, ElementsAre("Relay.Closes"));
    EXPECT_THAT(found.other_code, IsEmpty());
    EXPECT_EQ(found.regressions.size(), 1U);
}

TEST_F(Kills, CodeHashOfATestCoversEachItemThatTheTestVerifies) {
    const std::string one = code_by_test(evidence_).at("Relay.Closes");
    EXPECT_EQ(one.size(), 8U);
    claim("B", "Relay.Closes");
    const std::string two = code_by_test(evidence_).at("Relay.Closes");
    EXPECT_NE(two, one);
    claim("B", "Relay.Closes");
    EXPECT_EQ(code_by_test(evidence_).at("Relay.Closes"), two) << "claimed twice";
    evidence_.work["B"].code = "12345678";
    EXPECT_NE(code_by_test(evidence_).at("Relay.Closes"), two);
    EXPECT_EQ(code_by_test(evidence_).count("Relay.Missing"), 0U);
}

}  // namespace canproof::host::test
