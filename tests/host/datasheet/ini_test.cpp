// SPDX-License-Identifier: Apache-2.0
// Tests how an INI file (CiA 306) is read: sections, values, and loops that handle eight characters at a time.
#include "host/datasheet/ini.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/datasheet/eight_characters.hpp"

namespace {

using namespace canproof::host;

constexpr std::size_t longest = 20;  // two groups of eight characters, and four characters

/// Calls `check(text, at, c)` for texts of every length up to `longest` with the byte `c` at every place.
template <typename Check>
void for_each_byte_and_place(const Check& check) {
    for (std::size_t size = 1; size <= longest; ++size) {
        for (std::size_t at = 0; at < size; ++at) {
            for (int c = 0; c < 256; ++c) {
                std::string text(size, 'x');
                text[at] = static_cast<char>(c);
                check(text, at, c);
            }
        }
    }
}

struct Read {
    explicit Read(const std::string& text) : file{read_ini(text, EdsTelling{name, faults, notes})} {}

    std::string value(const char* section, const char* key) const {
        const IniValue* found = file.find(section)->find(key);
        return found == nullptr ? "absent" : std::string{found->text};
    }

    std::string name{"box.eds"};
    Faults faults;
    Faults notes;
    IniFile file;
};

}  // namespace

TEST(Ini, ControlCharactersExceptTabsAreFoundAtEveryPosition) {
    for_each_byte_and_place([](const std::string& text, std::size_t at, int c) {
        ASSERT_EQ(has_control(text), c < 0x20 && c != 0x09) << "byte " << c << " at " << at << " of " << text.size();
    });
}

TEST(Ini, OnlyTheLettersAToZBecomeLowerCase) {
    for_each_byte_and_place([](std::string text, std::size_t at, int c) {
        std::string expected = text;
        expected[at] = static_cast<char>(c >= 0x41 && c <= 0x5A ? c + 0x20 : c);  // A is 41h, a is 61h
        make_lower_case(text.data(), text.size());
        ASSERT_EQ(text, expected) << "byte " << c << " at " << at;
    });
}

TEST(Ini, SectionsWithTheirKeysInAnyOrderAreRead) {
    const Read read{"[A]\nb=1\na=2\n[B]\na=3\nb=4\n[C]\nb=5\nc=6\n[D]\nc=7\nb=8\n"};
    EXPECT_EQ(read.value("A", "a") + read.value("A", "B"), "21");
    EXPECT_EQ(read.value("B", "a") + read.value("B", "b"), "34");
    EXPECT_EQ(read.value("C", "b") + read.value("C", "c") + read.value("C", "a"), "56absent");
    EXPECT_EQ(read.value("D", "b") + read.value("D", "C"), "87");
    EXPECT_TRUE(read.notes.empty());
}

TEST(Ini, RepeatedKeyIsReportedEvenIfThePrecedingSectionHasEquallyManyKeys) {
    const Read read{"[A]\nb=1\na=2\n[B]\na=3\nA=4\n[C]\nb=5\na=6\n"};
    EXPECT_EQ(read.value("B", "a") + read.value("B", "b"), "3absent");
    EXPECT_EQ(read.value("C", "a") + read.value("C", "b"), "65");
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_EQ(read.notes.front().place.line, 6U);
    EXPECT_EQ(read.notes.front().what, "key A is already in line 5");
}

TEST(Ini, AssignmentReplacesAllSectionsOfAnIniFile) {
    Read read{"[A]\na=1\n"};
    const Read other{"[B]\nb=2\n"};
    read.file = read_ini("[C]\nc=3\n", EdsTelling{read.name, read.faults, read.notes});
    EXPECT_EQ(read.value("C", "c"), "3");
    EXPECT_EQ(read.file.find("A"), nullptr);
    EXPECT_EQ(other.value("B", "b"), "2");
}
