// SPDX-License-Identifier: Apache-2.0
// Tests that PDOs of a data sheet beyond those that a node supports are refused, each with its name.
#include "host/sim/devices/served_pdos.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/input_error.hpp"
#include "host/datasheet/read_eds.hpp"
#include "tests/host/datasheet/box_eds.hpp"

namespace canproof::host::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Returns the data sheet `box` with further PDO objects, each a RECORD with a COB-ID.
std::string box_with(const std::vector<std::string>& indices) {
    std::string text = box;
    for (const std::string& index : indices) {
        text += "[" + index + "]\nParameterName=PDO\nObjectType=9\n[" + index +
                "sub1]\nParameterName=COB-ID\nDataType=7\nAccessType=rw\nDefaultValue=0x80000000\n";
    }
    return text;
}

std::string refusal(const std::string& text) {
    try {
        check_served_pdos(read_eds(text, "box.eds").part);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(ServedPdos, PdosUpToTheEighthOfEachDirectionAreAccepted) {
    EXPECT_EQ(refusal(box_with({"1407", "1807", "1600", "1A00", "1607", "1A07"})), "");
}

TEST(ServedPdos, EachPdoBeyondTheEighthIsReportedWithItsFileAndLine) {
    const std::string text = box_with({"1407", "1408", "15FF", "1808", "19FF"});
    const auto at = [&](const std::string& section) {
        return "box.eds:" + std::to_string(line_of(text, "[" + section + "]")) + ": ";
    };
    EXPECT_THAT(
        refusal(text),
        AllOf(HasSubstr(at("1408") +
                        "RPDO 9 (1408h) is beyond the 8 PDOs of each direction that a simulated node supports\n"),
              HasSubstr(at("15FF") + "RPDO 512 (15FFh) "), HasSubstr(at("1808") + "TPDO 9 (1808h) "),
              HasSubstr(at("19FF") + "TPDO 512 (19FFh) "), Not(HasSubstr("1407h"))));
}

}  // namespace canproof::host::test
