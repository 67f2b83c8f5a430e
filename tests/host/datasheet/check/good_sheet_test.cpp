// SPDX-License-Identifier: Apache-2.0
// Tests the effect of patches on the good data sheet, which has no findings.
#include "tests/host/datasheet/check/good_sheet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace canproof::host::test {

TEST(GoodSheet, PatchSetsAKeyRemovesAKeyAndAddsALine) {
    const PatchedSheet sheet = patched_sheet("[FileInfo] FileVersion=9 | [FileInfo] -FileRevision | end ; done");
    EXPECT_EQ(sheet.text.rfind("[FileInfo]\nFileName=box.eds\nFileVersion=9\nEDSVersion=4.0\n", 0), 0U);
    EXPECT_EQ(sheet.text.substr(sheet.text.size() - 7), "; done\n");
    EXPECT_THAT(sheet.lines, testing::ElementsAre(1, 3, std::count(sheet.text.begin(), sheet.text.end(), '\n')));
}

}  // namespace canproof::host::test
