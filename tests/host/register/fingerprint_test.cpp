// SPDX-License-Identifier: Apache-2.0
// Tests that the fingerprint (hash) of an item changes with the content of the item, and with nothing else.
#include "host/register/fingerprint.hpp"

#include <gtest/gtest.h>

#include "host/base/fnv1a.hpp"

namespace canproof::host::test {

namespace {

Requirement printed_requirement(const std::string& text) {
    Requirement one;
    one.id = "AO4-R-1";
    one.text = text;
    return one;
}

Table table(std::int64_t output) {
    Table one;
    one.inputs.push_back({"a", "", "", "", 0, 1, {}, {}, Column::Kind::integers});
    one.outputs.push_back({"b", "", "", "", 0, 9, {}, {}, Column::Kind::integers});
    Cell any;
    Cell value;
    value.parts.push_back({output, output});
    one.rows.push_back({{any, value}, {}});
    return one;
}

}  // namespace

TEST(Fingerprint, Fnv1aGivesItsPublishedTestValues) {
    // Published test values of FNV-1a, 32 bit: "" and "a" and "foobar".
    EXPECT_EQ(fnv1a(""), 0x811C9DC5U);
    EXPECT_EQ(fnv1a("a"), 0xE40C292CU);
    EXPECT_EQ(fnv1a("foobar"), 0xBF9CF968U);
}

TEST(Fingerprint, FingerprintIgnoresSpacingFilePositionAndManualSource) {
    Requirement moved = printed_requirement("Opens  within\n  10 ms. ");
    moved.place = {"spec/x.toml", 9};
    moved.sources = {"M1:1"};
    EXPECT_EQ(fingerprint(moved), fingerprint(printed_requirement("Opens within 10 ms.")));
    EXPECT_EQ(fingerprint(moved).size(), 8U);
}

TEST(Fingerprint, FingerprintChangesWithText) {
    EXPECT_NE(fingerprint(printed_requirement("Opens within 10 ms.")),
              fingerprint(printed_requirement("Opens within 11 ms.")));
}

TEST(Fingerprint, FingerprintChangesWithATableCell) {
    EXPECT_NE(fingerprint(table(1)), fingerprint(table(2)));
    EXPECT_EQ(fingerprint(table(1)), fingerprint(table(1)));
    Table narrow = table(1);
    narrow.rows.front().cells.front().parts.push_back({std::int64_t{0}, std::int64_t{1}});
    EXPECT_NE(fingerprint(narrow), fingerprint(table(1)));
}

TEST(Fingerprint, FingerprintChangesWithTheDefaultTheLimitsOrTheAccessOfAnObject) {
    Object object;
    object.index = 0x2000;
    Entry entry;
    entry.type = "UNSIGNED8";
    entry.access = "rw";
    entry.value = std::int64_t{1};
    object.entries = {entry};
    const std::string before = fingerprint(object);
    object.entries.front().value = std::int64_t{2};
    const std::string other_default = fingerprint(object);
    object.entries = {entry};
    object.entries.front().access = "ro";
    const std::string other_access = fingerprint(object);
    object.entries = {entry};
    object.entries.front().range.maximum.kind = Limit::Kind::number;
    object.entries.front().range.maximum.number = std::int64_t{5};
    const std::string other_limit = fingerprint(object);
    EXPECT_NE(before, other_default);
    EXPECT_NE(before, other_access);
    EXPECT_NE(before, other_limit);
}

TEST(Fingerprint, EachRequirementAndTableOfADeviceHasAFingerprint) {
    Part part;
    part.requirements.push_back(printed_requirement("Opens."));
    part.tables.push_back(table(1));
    part.tables.front().id = "AO4-T1";
    const auto prints = fingerprints(part);
    ASSERT_EQ(prints.size(), 2U);
    EXPECT_EQ(prints.at("AO4-R-1"), fingerprint(printed_requirement("Opens.")));
    EXPECT_EQ(prints.at("AO4-T1"), fingerprint(table(1)));
}

}  // namespace canproof::host::test
