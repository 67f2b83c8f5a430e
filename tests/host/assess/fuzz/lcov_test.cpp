// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/lcov.hpp"

#include <gtest/gtest.h>

namespace canproof::host {
namespace {

TEST(Lcov, FilteredLcovKeepsTheFirmwareOnly) {
    const auto files = read_lcov(
        "SF:/w/src/host/x.cpp\nDA:1,1\nend_of_record\n"
        "SF:/w/build/../src/firmware/base/crc.cpp\nFN:3,_ZN8canproof5crc16Ei\nFNDA:0,_ZN8canproof5crc16Ei\n"
        "FNDA:2,_ZN8canproof5crc32Ei\nDA:3,0\nDA:4,0\nDA:5,0\nDA:7,9\nDA:9,0\nend_of_record\n");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0].path, "src/firmware/base/crc.cpp");
    EXPECT_EQ(files[0].lines, 5U);
    EXPECT_EQ(files[0].hit, 1U);
    EXPECT_EQ(files[0].unreached, "3-5, 9");
    EXPECT_EQ(files[0].functions, std::vector<std::string>{"canproof::crc16(int)"});
}

TEST(Lcov, FilteredLcovKeepsDeviceFirmwareAndNotItsSimulation) {
    const auto files = read_lcov(
        "SF:/w/src/devices/ax130751/simulation/model.cpp\nDA:1,1\nend_of_record\n"
        "SF:/w/src/devices/ax130751/firmware/ramp.cpp\nDA:1,1\nDA:2,0\nend_of_record\n");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0].path, "src/devices/ax130751/firmware/ramp.cpp");
    EXPECT_EQ(files[0].lines, 2U);
    EXPECT_EQ(files[0].hit, 1U);
}

TEST(Lcov, RecordsOfOneFileAreMerged) {
    const auto files = read_lcov(
        "SF:/w/src/firmware/a.hpp\nDA:1,0\nDA:2,4\nend_of_record\nSF:/w/src/firmware/a.hpp\nDA:1,1\nend_of_record\n");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0].lines, 2U);
    EXPECT_EQ(files[0].hit, 2U);
    EXPECT_EQ(files[0].unreached, "");
}

}  // namespace
}  // namespace canproof::host
