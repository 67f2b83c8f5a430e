// Files and lines: what is read, and what is refused instead of taken for the end.
#include "host/base/reading.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace canproof::host {

TEST(WholeFile, FolderAndMissingFileAreRefused) {
    EXPECT_THROW(read_file("/"), InputError);
    EXPECT_THROW(read_file("/nosuch/file"), InputError);
}

TEST(WholeFile, NoMoreThanABoundIsRead) {
    EXPECT_THROW(read_file("/dev/zero", 1000), InputError);
    EXPECT_EQ(read_file("/dev/null", 0), "");
}

TEST(WholeFile, BytesAreThoseOfTheFile) {
    const auto path = std::filesystem::path{testing::TempDir()} / "whole_file";
    std::string bytes(200000, 'x');
    bytes[70000] = '\0';
    bytes[199999] = '\n';
    std::ofstream{path, std::ios::binary} << bytes;
    EXPECT_EQ(read_file(path), bytes);
    EXPECT_EQ(read_file(path, 200000), bytes);
    EXPECT_THROW(read_file(path, 199999), InputError);
    std::filesystem::remove(path);
}

TEST(Lines, EndsMarksAndTheLastLineWithoutEnd) {
    std::istringstream in{"\xEF\xBB\xBFone\r\n\ntwo"};
    LineReader lines{in, "file"};
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "one");
    EXPECT_EQ(lines.where(), "file:1");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "two");
    EXPECT_EQ(lines.where(), "file:3");
    EXPECT_FALSE(lines.next());
    EXPECT_FALSE(lines.next());
}

TEST(Lines, LongestLineIsReadAndALongerOneRefused) {
    const std::string longest(LineReader::longest_line, 'x');
    for (const std::string& end : {"", "\n"}) {
        std::istringstream in{longest + end};
        LineReader lines{in, "file"};
        ASSERT_TRUE(lines.next());
        EXPECT_EQ(lines.line(), longest);
        EXPECT_FALSE(lines.next());
    }
    std::istringstream in{longest + "x\n"};
    LineReader lines{in, "file"};
    EXPECT_THROW(lines.next(), InputError);
}

TEST(Lines, ReadErrorIsNoEnd) {
    std::ifstream folder{"/", std::ios::binary};
    LineReader lines{folder, "/"};
    EXPECT_THROW(lines.next(), InputError);
}

}  // namespace canproof::host
