// SPDX-License-Identifier: Apache-2.0
// Tests exhibits, which are folders with the results of other tools that the evidence pack shows.
#include "host/assess/evidence/exhibit.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class EvidenceFolder : public ::testing::Test {
  protected:
    EvidenceFolder() : root_{std::filesystem::path{::testing::TempDir()} / "exhibits"} {
        std::filesystem::create_directories(root_ / "fuzz" / "data");
        std::filesystem::create_directories(root_ / "empty");
        write("fuzz/exhibit.json",
              R"({"title": "Fuzzing", "state": "open", "says": "one finding", "page": "report.html",
                  "figures": {"targets": 18, "edges": "1,234"}, "open": ["a crash"], "data": ["data/a"]})");
        write("fuzz/report.html", "<p>");
        write("fuzz/data/a", "b");
    }
    ~EvidenceFolder() override { std::filesystem::remove_all(root_); }
    void write(const std::string& name, const std::string& text) const { std::ofstream{root_ / name} << text; }
    /// Returns the error message for an exhibit.json with this text, or the title of a valid exhibit.
    std::string told(const std::string& text) const {
        write("fuzz/exhibit.json", text);
        try {
            return read_exhibit(root_ / "fuzz").title;
        } catch (const InputError& error) {
            return error.what();
        }
    }

    std::filesystem::path root_;
};

TEST_F(EvidenceFolder, EvidenceIsReadWithItsStatePageFiguresAndFiles) {
    // Paths are compared as text: GoogleTest would print them as nested lists.
    ASSERT_EQ(exhibit_folders(root_).size(), 1U);
    EXPECT_EQ(exhibit_folders(root_)[0].string(), (root_ / "fuzz").string());
    EXPECT_TRUE(exhibit_folders(root_ / "nowhere").empty());
    const Exhibit found = read_exhibit(root_ / "fuzz");
    EXPECT_EQ(found.key, "fuzz");
    EXPECT_EQ(found.state, Exhibit::State::open);
    EXPECT_EQ(found.page, "fuzz/report.html");
    EXPECT_EQ(found.files, (std::map<std::string, std::string>{{"fuzz/data/a", "b"}, {"fuzz/report.html", "<p>"}}));
    EXPECT_THAT(found.figures, ElementsAre(std::pair{"targets", "18"}, std::pair{"edges", "1,234"}));
    EXPECT_THAT(found.open, ElementsAre("a crash"));
    EXPECT_THAT(found.data, ElementsAre("fuzz/data/a"));
}

TEST_F(EvidenceFolder, EvidenceWithAnInvalidDescriptionIsRefused) {
    EXPECT_THAT(told(R"({"title": "x", "state": "fine", "says": ""})"), HasSubstr("state `fine` is neither"));
    EXPECT_THAT(told(R"({"title": "x"})"), HasSubstr("it needs title, state and says"));
    EXPECT_THAT(told("nothing"), HasSubstr("exhibit.json"));
    EXPECT_THAT(told(R"({"title": "x", "state": "open", "says": "", "page": "none.html"})"),
                HasSubstr("there is no fuzz/none.html"));
    EXPECT_THAT(told(R"({"title": "x", "state": "open", "says": "", "data": ["none"]})"),
                HasSubstr("there is no fuzz/none"));
    EXPECT_EQ(told(R"({"title": "x", "state": "open", "says": ""})"), "x");
}

}  // namespace

}  // namespace canproof::host::test
