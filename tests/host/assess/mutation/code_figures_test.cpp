// SPDX-License-Identifier: Apache-2.0
// Tests reports/code_figures.csv, which has the counts of mutants of each source file at its last mutation run, and
// their sums by layer of the code.
#include "host/assess/mutation/code_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const char* const crc = "src/firmware/base/crc.hpp";
const char* const relay = "src/devices/box/firmware/relay.cpp";
const SurvivorRecord explained{"*", "*", "*", "A reason.", 1};

class CodeFiguresTrial : public testing::Test {
  protected:
    CodeFiguresTrial() {
        write(crc, "int f() { return 1 + 2; }  // a comment\n");
        write(relay, "int g() { return 3; }\n");
        note_figures(figures,
                     {{{0, crc, "f, line 1", "a"}, "Sdo.One", true, nullptr, "tests/conformance/sdo_test.cpp"},
                      {{1, crc, "f, line 1", "b"}, "Crc.One", true, nullptr, "tests/firmware/crc_test.cpp"},
                      {{2, crc, "f, line 1", "c"}, "Law.One", true, nullptr, "properties/base/crc_property.cpp"},
                      {{3, crc, "f, line 1", "d"}, "signal 11", true, nullptr, ""},
                      {{4, crc, "f, line 1", "e"}, "", true, &explained, ""},
                      {{5, relay, "g, line 1", "f"}, "", true, nullptr, ""}},
                     folder / "");
    }
    void write(const std::string& file, const std::string& text) {
        std::filesystem::create_directories((folder / file).parent_path());
        write_file(folder / file, text);
    }
    LayerTable table() const { return layer_table(figures, mutants, folder / ""); }

    canproof::test::ScratchFolder folder;
    CodeFigures figures;
    std::vector<AlteredCell> mutants{{0, crc, "", ""}, {1, crc, "", ""}, {2, crc, "", ""},
                                     {3, crc, "", ""}, {4, crc, "", ""}, {5, relay, "", ""}};
};

}  // namespace

TEST_F(CodeFiguresTrial, MutationFiguresAreAddedUpByCodeLayerAndKindOfTest) {
    const LayerTable found = table();
    EXPECT_THAT(found.text, HasSubstr("| base | 5 | 4 (80.0 %) | 1 | 1 | 1 | 1 | 1 | 0 |\n"));
    EXPECT_THAT(found.text, HasSubstr("| box | 1 | 0 (0.0 %) | 0 | 0 | 0 | 0 | 0 | 1 |\n"));
    EXPECT_THAT(found.text, HasSubstr("| all | 6 | 4 (66.7 %) | 1 | 1 | 1 | 1 | 1 | 1 |\n"));
    EXPECT_EQ(found.open, 1U);
    EXPECT_THAT(found.unjudged, IsEmpty());
}

TEST_F(CodeFiguresTrial, LaterMutationRunReplacesTheFiguresOfItsFilesOnly) {
    note_figures(figures, {{{5, relay, "g, line 1", "f"}, "Box.One", true, nullptr, "tests/devices/box/box_test.cpp"}},
                 folder / "");
    const LayerTable found = table();
    EXPECT_THAT(found.text, HasSubstr("| box | 1 | 1 (100.0 %) | 0 | 1 | 0 | 0 | 0 | 0 |\n"));
    EXPECT_THAT(found.text, HasSubstr("| base | 5 | 4 "));
    EXPECT_EQ(found.open, 0U);
}

TEST_F(CodeFiguresTrial, NewCommentOrImplementsLinkKeepsMutationFigures_AndChangedCodeLosesThem) {
    write(relay, "static_assert(implements<req::A> && implements<req::B>);\nint  g() { return 3; }  // three\n");
    EXPECT_THAT(table().unjudged, IsEmpty());
    write(relay, "int g() { return 4; }\n");
    const LayerTable found = table();
    EXPECT_THAT(found.unjudged, ElementsAre("src/devices/box/firmware/relay.cpp (1 mutants)"));
    EXPECT_THAT(found.text, Not(HasSubstr("| box |")));
    EXPECT_EQ(found.open, 0U);
}

TEST_F(CodeFiguresTrial, FileIsListedAsNotYetMutatedIfItIsNewOrItsNumberOfMutantsDiffers) {
    mutants.pop_back();
    mutants.push_back({6, "src/firmware/base/new.hpp", "", ""});
    mutants.push_back({7, crc, "", ""});
    EXPECT_THAT(table().unjudged,
                ElementsAre("src/firmware/base/crc.hpp (6 mutants)", "src/firmware/base/new.hpp (1 mutants)"));
    EXPECT_THAT(table().text, Not(HasSubstr("all")));
}

TEST_F(CodeFiguresTrial, RemovedFileLosesItsMutationFigures) {
    std::filesystem::remove(folder / relay);
    note_figures(figures, {}, folder / "");
    EXPECT_EQ(figures.count(relay), 0U);
    EXPECT_EQ(figures.count(crc), 1U);
}

TEST_F(CodeFiguresTrial, MutationFiguresAreReadBackAsWritten) {
    const auto file = folder / "code_figures.csv";
    EXPECT_TRUE(read_code_figures(file).empty());
    const std::string text = write_code_figures(figures);
    EXPECT_THAT(text, HasSubstr("src/firmware/base/crc.hpp," + figures[crc].code + ",5,1,1,1,1,1,0\n"));
    EXPECT_EQ(figures[crc].code.size(), 8U);
    write_file(file, text);
    EXPECT_EQ(write_code_figures(read_code_figures(file)), text);
    for (const char* line : {"a.cpp", ",1,2,3,4,5,6,7,8", "a.cpp,1,2,3,4,5,6,7", "a.cpp,1,2,3,4,5,6,7,8,9",
                             "a.cpp,1,2,3,x,5,6,7,8", "a.cpp,1,2,3,,5,6,7,8", "a.cpp,1,2,3,1234567890,5,6,7,8"}) {
        write_file(file, std::string{line} + "\n");
        EXPECT_THROW(read_code_figures(file), InputError) << line;
    }
}

}  // namespace canproof::host::test
