// SPDX-License-Identifier: Apache-2.0
// Tests the effects of a change: two registers are compared, a revision is read from a small git repository, and the
// affected items and changed test results are listed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "host/assess/change/impact.hpp"
#include "host/assess/change/revision.hpp"
#include "host/assess/change/work_change.hpp"
#include "host/assess/source/test_bodies.hpp"
#include "host/base/child_process.hpp"
#include "host/base/input_error.hpp"
#include "host/register/load.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

std::string items(const std::string& text, int value, int cell) {
    return "[[requirement]]\nid = \"AO4-R-1\"\ntext = \"" + text +
           "\"\nsource = [\"M1:1\"]\nkind = \"functional\"\nverify = [\"test\"]\n"
           "[[object]]\nindex = 0x2000\nname = \"Limit\"\ntype = \"UNSIGNED8\"\naccess = \"rw\"\ndefault = " +
           std::to_string(value) +
           "\nsource = [\"M1:1\"]\n"
           "[[table]]\nid = \"AO4-T-1\"\ntitle = \"x\"\nsource = [\"M1:Table 3\"]\ninputs = [\"on\"]\noutputs = "
           "[\"out\"]\n"
           "rows = [ [false, 0], [true, " +
           std::to_string(cell) + "] ]\n";
}

Register read(const std::string& text, int value, int cell) {
    return load_register(with(items_file, items(text, value, cell))).content;
}

const ItemChange* change_of(const std::string& id, const std::vector<ItemChange>& changes) {
    for (const auto& change : changes) {
        if (change.id == id) {
            return &change;
        }
    }
    return nullptr;
}

/// A repository with one commit that contains the small register; the destructor removes it.
class Repository {
  public:
    Repository() : root_{fs::temp_directory_path() / ("canproof-diff-" + std::to_string(getpid()))} {
        fs::remove_all(root_);
        fs::create_directories(root_);
        for (const auto& [path, text] : with(items_file, items("Opens.", 5, 1))) {
            write(path, text);
        }
        write("src/a.cpp", "// one\n");
        git({"init", "-q"});
        commit();
    }
    Repository(const Repository&) = delete;
    Repository& operator=(const Repository&) = delete;
    ~Repository() { fs::remove_all(root_); }

    void write(const std::string& path, const std::string& text) const {
        fs::create_directories((root_ / path).parent_path());
        std::ofstream{root_ / path} << text;
    }
    void commit() const {
        git({"add", "."});
        git({"-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false", "commit", "-q", "-m",
             "all"});
    }
    const fs::path& root() const { return root_; }

  private:
    void git(std::vector<std::string> words) const {
        words.insert(words.begin(), {"git", "-C", root_.string()});
        ASSERT_TRUE(output_of(words).has_value()) << words[3];
    }
    fs::path root_;
};

}  // namespace

TEST(RegisterDiff, RegisterDoesNotDifferFromItself) {
    EXPECT_TRUE(compare(read("Opens.", 5, 1), read("Opens.", 5, 1)).empty());
}

TEST(RegisterDiff, ChangesOfRequirementTextDefaultValueAndTableCellAreListed) {
    const auto changes = compare(read("Opens.", 5, 1), read("Closes.", 6, 2));
    ASSERT_EQ(changes.size(), 3U);
    EXPECT_THAT(change_of("AO4-R-1", changes)->details, ElementsAre("text: Opens. -> Closes."));
    EXPECT_THAT(change_of("AO4-OD-2000", changes)->details, ElementsAre("sub 0 default: 5 -> 6"));
    EXPECT_THAT(change_of("AO4-T-1", changes)->details, ElementsAre("row   2: true, 1 -> true, 2"));
}

TEST(RegisterDiff, AddedAnswerOfARequirementToADecisionTopicIsListed) {
    Register after = read("Opens.", 5, 1);
    const_cast<Part&>(*after.part("box")).requirements[0].answer = {"valve.move", "opens", "its manual", "", {}};
    const auto changes = compare(read("Opens.", 5, 1), after);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_THAT(changes[0].details, ElementsAre(HasSubstr("choice: "), HasSubstr("differs: "), HasSubstr("topic: ")));
}

TEST(RegisterDiff, AddedAndRemovedItemsAreListed) {
    Register after = read("Opens.", 5, 1);
    Part& box = const_cast<Part&>(*after.part("box"));
    box.requirements[0].id = "AO4-R-2";
    const auto changes = compare(read("Opens.", 5, 1), after);
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].kind, ItemChange::Kind::removed);
    EXPECT_EQ(changes[1].kind, ItemChange::Kind::added);
}

TEST(RegisterDiff, ChangedStatementIsRecognisedByTheHashOfItsManualPassage) {
    const auto read_statements = [](const std::string& text) {
        SpecFiles files = with(items_file, items("Opens.", 5, 1));
        files["spec/manuals/m/1.toml"] = text;
        return load_register(files).content;
    };
    const auto statement = [](const std::string& mark, const std::string& covered) {
        return "[[statement]]\nsection = \"1\"\ntext = \"It opens.\"\nmark = \"" + mark + "\"\ncovered = [\"" +
               covered + "\"]\n";
    };
    const std::string first = statement("8:00000000000a", "AO4-R-1");
    const auto changes = compare(read_statements(first), read_statements(statement("7:00000000000b", "AO4-R-1") +
                                                                         statement("8:00000000000a", "AO4-OD-2000")));
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].id, "M1:1 7:00000000000b");
    EXPECT_EQ(changes[0].kind, ItemChange::Kind::added);
    EXPECT_EQ(changes[1].id, "M1:1 8:00000000000a");
    EXPECT_EQ(changes[1].word, "statement");
    EXPECT_THAT(changes[1].details, ElementsAre("covered: AO4-R-1 -> AO4-OD-2000"));
}

TEST(Revision, RevisionIsReadFromGitAndComparedWithTheWorkTree) {
    const Repository repository;
    repository.write(items_file, items("Opens.", 7, 1));
    repository.write("src/a.cpp", "// two\n");
    repository.write("src/new.cpp", "// three\n");
    const Register before = load_register(spec_files_at(repository.root(), "HEAD")).content;
    const Register after = load_register(repository.root() / "spec").content;
    const auto changes = compare(before, after);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_THAT(changes[0].details, ElementsAre("sub 0 default: 5 -> 7"));
    EXPECT_THAT(files_changed_since(repository.root(), "HEAD", {"src"}), ElementsAre("src/a.cpp", "src/new.cpp"));
}

TEST(Revision, UnknownRevisionIsAnInputError) {
    const Repository repository;
    EXPECT_THROW(spec_files_at(repository.root(), "nowhere"), InputError);
    EXPECT_THROW(spec_files_at(repository.root(), "--upload-pack=x"), InputError);
}

TEST(Impact, ImpactListsCodeAndTestsOfChangedItems_AndItemsOfChangedFiles) {
    const Register after = read("Closes.", 5, 1);
    Evidence evidence;
    evidence.implemented["AO4-R-1"] = {"src/firmware/a.cpp:7"};
    evidence.implemented["AO4-OD-2000"] = {"src/firmware/b.cpp:8"};
    evidence.verdicts["AO4-R-1"] = {{"Box.Closes", "test", true, 0.0, "tests/devices/box_test.cpp"}};
    const Impact impact{compare(read("Opens.", 5, 1), after), {"src/firmware/b.cpp"}, {}, {}};
    const std::string text = write_impact(impact, after, evidence);
    EXPECT_THAT(text, HasSubstr("requirement AO4-R-1 changed"));
    EXPECT_THAT(text, HasSubstr("src/firmware/a.cpp:7"));
    EXPECT_THAT(text, HasSubstr("passed Box.Closes tests/devices/box_test.cpp"));
    EXPECT_THAT(text, HasSubstr("file src/firmware/b.cpp\n    items     AO4-OD-2000"));
    EXPECT_THAT(text,
                HasSubstr("1 item(s) and 1 file(s) changed, 2 item(s) affected in total, 0 test result(s) differ"));
    evidence.implemented_by = {{"AO4-R-2", "AO4-OD-2000"}};
    EXPECT_THAT(write_impact(impact, after, evidence),
                HasSubstr("file src/firmware/b.cpp\n    items     AO4-OD-2000, AO4-R-2"));
}

TEST(Impact, ItemsWithChangedCodeOrTestsAreListedWithTheirFunctionsAndTests) {
    const ItemWork same{"1", "2", {{"src/a.cpp:1", "f", "1"}}, {{"tests/a_test.cpp", "F.Is", "2"}}};
    const ItemWork code{"9", "2", {{"src/a.cpp:1", "f", "9"}}, {{"tests/a_test.cpp", "F.Is", "2"}}};
    const ItemWork untested{"1", "", {{"src/a.cpp:1", "f", "1"}}, {}};
    const auto changes =
        work_changes({{"A", same}, {"B", same}, {"C", untested}, {"D", same}}, {{"A", same}, {"B", code}, {"C", same}});
    ASSERT_EQ(changes.size(), 3U);
    EXPECT_EQ(changes[0].id, "B");
    EXPECT_TRUE(changes[0].code && !changes[0].tests);
    ASSERT_EQ(changes[0].parts.size(), 1U);
    EXPECT_EQ(changes[0].parts[0].name + " " + changes[0].parts[0].file, "f src/a.cpp:1");
    EXPECT_EQ(changes[1].id, "C");
    EXPECT_TRUE(!changes[1].code && changes[1].tests);
    ASSERT_EQ(changes[1].parts.size(), 1U);
    EXPECT_EQ(changes[1].parts[0].name, "F.Is");
    EXPECT_EQ(changes[2].id, "D");  // the deleted lines contained the item's implements<> and its tests
    EXPECT_TRUE(changes[2].code && changes[2].tests);
    EXPECT_TRUE(changes[2].parts.empty());
    const Impact impact{{}, {}, {}, changes};
    const std::string text = write_impact(impact, {}, {});
    EXPECT_THAT(text, HasSubstr("stale B: its code has changed\n    changed   f src/a.cpp:1\nstale C"));
    EXPECT_THAT(impact_json(impact), HasSubstr("\"place\": \"tests/a_test.cpp\""));
}

TEST(Revision, RenamedTestWithTheSameBodyIsNoChangeOfItsItem) {
    const Repository repository;
    const std::string test = "TEST(F, Is) {\n    verifies<req::AO4_R_1>();\n    EXPECT_EQ(f(), 1);\n}\n";
    repository.write("tests/a_test.cpp", test);
    repository.commit();
    const WorkPart now{"tests/a_test.cpp", "F.IsAlways1",
                       TestBodies{repository.root()}.hash("tests/a_test.cpp", "F.Is")};
    const auto verdicts = [&](const std::string& name) {
        repository.write("verdicts/tests.xml",
                         "<testsuites><testsuite name=\"F\"><testcase name=\"" + name +
                             "\" classname=\"F\" file=\"tests/a_test.cpp\" status=\"run\" time=\"0\">"
                             "<properties><property name=\"AO4-R-1\" value=\"test\"/></properties>"
                             "</testcase></testsuite></testsuites>");
        return repository.root() / "verdicts";
    };
    const Register content = read("Opens.", 5, 1);
    const auto hash_at = [&](const std::string& present_hash) {
        const WorkByItem present{{"AO4-R-1", {"", "", {}, {{now.file, now.name, present_hash}}}}};
        return work_at(repository.root(), "HEAD", verdicts("IsAlways1"), content, present)
            .at("AO4-R-1")
            .bodies.at(0)
            .hash;
    };
    ASSERT_FALSE(now.hash.empty());
    EXPECT_EQ(hash_at(now.hash), now.hash);
    EXPECT_EQ(hash_at("0123456789abcdef"), "") << "another body under a new name is a change";
}

TEST(Impact, ItemsWhoseTestResultChangedAreListed) {
    Evidence before;
    Evidence after;
    before.verdicts = {{"A", {{"S.A", "test", true}}}, {"B", {{"S.B", "test", true}}}, {"C", {{"S.C", "test", true}}}};
    after.verdicts = {{"A", {{"S.A", "test", true}, {"S.A2", "test", false}}}, {"B", {{"S.B", "test", true}}}};
    const auto changes = verdict_changes(before, after);
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].id + changes[0].before + changes[0].after, "Apassedfailed");
    EXPECT_EQ(changes[1].id + changes[1].before + changes[1].after, "Cpassednone");
}

}  // namespace canproof::host::test
