// SPDX-License-Identifier: Apache-2.0
// Statements of a manual: read from the folder of the manual, numbered, and checked against the register.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "host/register/statement.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string first_file = "spec/manuals/m/1-objects.toml";
const std::string second_file = "spec/manuals/m/2-rates.toml";

const std::string statement_items = R"([[requirement]]
id = "AO4-R-1"
text = "When the bus is lost, the box shall put its output to 0 V."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
[[requirement]]
id = "AO4-R-2"
text = "When it starts, the box shall blink."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
retired = "merged"
[[decision]]
id = "AO4-D-1"
question = "?"
readings = [ { says = "a", source = "M1:1" }, { says = "b", source = "M1:Table 3" } ]
chosen = "a"
because = "safer failure"
affects = ["AO4-R-1"]
severity = "low"
)";

const std::string covered = R"([[statement]]
section = "1"
text = "The output is 0 V without a bus."
mark = "20:3f9a0c1b2d4e"
covered = ["AO4-R-1", "AO4-D-1"]
)";

const std::string explained = R"([[statement]]
section = "2000h"
text = "The cover is grey."
mark = ["9:00000000000a", "10:00000000000b"]
reason = "hardware"
)";

SpecFiles with_statements(const std::string& text) {
    SpecFiles files = with(items_file, statement_items);
    files[first_file] = text;
    return files;
}

std::string edited_statement(const std::string& from, const std::string& to, std::string text = covered) {
    return text.replace(text.find(from), from.size(), to);
}

std::string statement_faults(const std::string& text) {
    return all_faults(load_register(with_statements(text)));
}

}  // namespace

TEST(ManualStatements, StatementsAreReadAsWritten) {
    const LoadResult loaded = load_register(with_statements(covered + explained));
    EXPECT_EQ(all_faults(loaded), "");
    const Manual& manual = *loaded.content.manual("M1");
    ASSERT_THAT(manual.statements, SizeIs(2));
    const Statement& one = manual.statements[0];
    EXPECT_EQ(one.id("M1"), "M1:1/1");
    EXPECT_EQ(one.text, "The output is 0 V without a bus.");
    EXPECT_THAT(one.marks, ElementsAre(Mark{20, "3f9a0c1b2d4e"}));
    EXPECT_THAT(one.covered, ElementsAre("AO4-R-1", "AO4-D-1"));
    EXPECT_EQ(one.place.line, 1U);
    const Statement& other = manual.statements[1];
    EXPECT_EQ(other.id("M1"), "M1:2000h/1");
    EXPECT_THAT(other.marks, ElementsAre(Mark{9, "00000000000a"}, Mark{10, "00000000000b"}));
    EXPECT_EQ(other.reason, "hardware");
}

TEST(ManualStatements, StatementsAreNumberedBySectionInFileAndLineOrder) {
    SpecFiles files = with_statements(covered + explained + edited_statement("20:", "21:"));
    files[second_file] =
        edited_statement("20:", "22:") + edited_statement("\"1\"", "\"Table 3\"", edited_statement("20:", "23:"));
    const LoadResult loaded = load_register(files);
    EXPECT_EQ(all_faults(loaded), "");
    std::vector<std::string> ids;
    for (const Statement& one : loaded.content.manual("M1")->statements) {
        ids.push_back(one.id("M1"));
    }
    EXPECT_THAT(ids, ElementsAre("M1:1/1", "M1:2000h/1", "M1:1/2", "M1:1/3", "M1:Table 3/1"));
}

TEST(ManualStatements, StatementsMayBeAbsent) {
    const LoadResult loaded = load_register(with(items_file, statement_items));
    EXPECT_EQ(all_faults(loaded), "");
    EXPECT_THAT(loaded.content.manual("M1")->statements, IsEmpty());
}

TEST(ManualStatements, UncoveredStatementsAreNoFault) {
    EXPECT_EQ(statement_faults(edited_statement("covered = [\"AO4-R-1\", \"AO4-D-1\"]\n", "")), "");
    const LoadResult loaded = load_register(with_statements(edited_statement("\"AO4-R-1\", \"AO4-D-1\"", "")));
    EXPECT_EQ(all_faults(loaded), "");
    EXPECT_TRUE(loaded.content.manual("M1")->statements.at(0).is_open());
}

TEST(ManualStatements, StatementOfAnUnknownSectionIsRefused) {
    EXPECT_THAT(statement_faults(edited_statement("\"1\"", "\"4.2\"")),
                HasSubstr("spec/manuals/m/1-objects.toml:2: M1 has no section 4.2; correct the section, or add 4.2 to "
                          "spec/manuals/m.toml"));
}

TEST(ManualStatements, StatementCoveredByAnInvalidItemIsRefused) {
    EXPECT_THAT(statement_faults(edited_statement("AO4-R-1", "AO4-R-9")),
                HasSubstr("1-objects.toml:5: M1:1/1 is covered by AO4-R-9, which does not exist; correct the id"));
    EXPECT_THAT(statement_faults(edited_statement("AO4-R-1", "AO4-R-2")),
                HasSubstr("is covered by AO4-R-2, which is retired; name an item that is not retired"));
    EXPECT_THAT(statement_faults(edited_statement("AO4-D-1", "AO4-R-1")),
                HasSubstr("is covered by AO4-R-1, which `covered` names twice; name the item once"));
    SpecFiles files = with_statements(covered);
    files["spec/manuals/other.toml"] =
        "key = \"M2\"\ntitle = \"t\"\npublisher = \"p\"\nrevision = \"1\"\ndate = \"d\"\n"
        "[[section]]\nref = \"1\"\ntitle = \"t\"\ndisposition = \"normative\"\n";
    files["spec/manuals/other/1.toml"] = covered;
    EXPECT_THAT(all_faults(load_register(files)),
                HasSubstr("other/1.toml:5: M2:1/1 is covered by AO4-R-1, which belongs to another device; name an item "
                          "of a device with this manual, or a shared one"));
}

TEST(ManualStatements, StatementsMayBeCoveredByASharedItem) {
    SpecFiles files = with_statements(edited_statement("AO4-D-1", "CO-R-1"));
    files[shared_file] =
        "[[requirement]]\nid = \"CO-R-1\"\ntext = \"It shall answer.\"\nsource = [\"CiA301:7\"]\n"
        "kind = \"protocol\"\nverify = [\"test\"]\n";
    EXPECT_EQ(all_faults(load_register(files)), "");
}

TEST(ManualStatements, StatementWithItemsAndAReasonIsAFault) {
    EXPECT_THAT(statement_faults(covered + "reason = \"hardware\"\n"),
                HasSubstr("1-objects.toml:1: a statement has both `covered` and `reason`"));
}

TEST(ManualStatements, MissingMalformedOrRepeatedPassageHashIsRefused) {
    EXPECT_THAT(statement_faults(edited_statement("mark = \"20:3f9a0c1b2d4e\"\n", "")), HasSubstr("mark is missing"));
    EXPECT_THAT(statement_faults(edited_statement("\"20:3f9a0c1b2d4e\"", "[]")),
                HasSubstr("mark is not a list of strings, not empty"));
    EXPECT_THAT(statement_faults(edited_statement("20:3f9a0c1b2d4e", "20:3f9a")),
                HasSubstr("1-objects.toml:4: mark 20:3f9a is malformed; write LENGTH:HASH"));
    EXPECT_THAT(statement_faults(covered + covered),
                HasSubstr("1-objects.toml:9: mark 20:3f9a0c1b2d4e (hash of a passage) also belongs to M1:1/1; write "
                          "the mark of another passage"));
}

TEST(ManualStatements, StatementsInAFolderWithoutAManualAreRefused) {
    SpecFiles files = with(items_file, statement_items);
    files["spec/manuals/n/1.toml"] = covered;
    EXPECT_THAT(all_faults(load_register(files)),
                HasSubstr("spec/manuals/n/1.toml:1: the folder belongs to no manual"));
}

TEST(ManualStatements, UnknownKeyInAFileOfStatementsIsRefused) {
    EXPECT_THAT(statement_faults("[[section]]\nref = \"9\"\n" + covered), HasSubstr("the key `section` is unknown"));
    EXPECT_THAT(statement_faults(covered + "author = \"me\"\n"), HasSubstr("the key `author` is unknown"));
}

}  // namespace canproof::host::test
