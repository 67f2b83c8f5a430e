// SPDX-License-Identifier: Apache-2.0
// Details of data sheets on which foreign tools depend: object codes of CiA 301, the count of errors, REAL32.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "host/datasheet/eds_values.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_dictionary.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/datasheet/write_xdd.hpp"
#include "host/register/load.hpp"
#include "host/selection/built_in.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

const std::string tool_objects = R"([[object]]
index = 0x1003
name = "Errors"
type = "UNSIGNED32"
array = 4
access = "ro"
default = 0
live = true
source = ["M1:1"]
[[object.entry]]
sub = 0
name = "Number of errors"
type = "UNSIGNED8"
access = "rw"
default = 0
stored = false
range = { values = [0] }
[[object]]
index = 0x1600
name = "RPDO1 mapping"
type = "UNSIGNED32"
array = 2
kind = "record"
access = "ro"
default = 0
source = ["M1:1"]
[[object]]
index = 0x2000
name = "Gain"
type = "REAL32"
access = "rw"
default = 1.5
range = { min = -2.0, max = 8.0 }
source = ["M1:2000h"]
)";

class ToolSheet : public testing::Test {
  protected:
    ToolSheet() : loaded_{load_register(with(items_file, tool_objects))} {}
    void SetUp() override {
        for (const auto& fault : loaded_.faults) {
            ADD_FAILURE() << fault.text();
        }
    }
    const Part& box() const { return *loaded_.content.part("box"); }
    std::string eds(Reals reals = Reals::without_limits) const { return write_eds(loaded_.content, box(), reals); }
    LoadResult loaded_;
};

}  // namespace

TEST_F(ToolSheet, PdoMappingObjectIsARecordInEdsXddAndJson) {
    EXPECT_THAT(eds(), HasSubstr(crlf("[1600]\nParameterName=RPDO1 mapping\nObjectType=0x9\n")));
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(write_xdd(loaded_.content, box()).c_str()));
    const auto mapping = document.select_node("//CANopenObject[@index='1600']").node();
    EXPECT_STREQ(mapping.attribute("objectType").value(), "9");
    const auto json = nlohmann::json::parse(write_object_json(box()));
    EXPECT_EQ(json.at("objects").at(1).at("kind"), "RECORD");
}

TEST_F(ToolSheet, EveryPdoMappingObjectOfEveryDeviceIsARecord) {
    int mappings = 0;
    for (const Part& part : built_in_register().parts) {
        for (const Object& object : part.objects) {
            if ((object.index & 0xFE00U) == 0x1600U || (object.index & 0xFE00U) == 0x1A00U) {
                EXPECT_EQ(object.kind, Object::Kind::record) << part.name << ' ' << object.id;
                ++mappings;
            }
        }
    }
    EXPECT_EQ(mappings,
              3 * 8 + 2);  // three devices with four RPDOs and four TPDOs each, and two RPDOs of the CAN-CBX-AO412
}

// 1003h (pre-defined error field) sub-index 0 reads 0 to 4 here. A write may only contain 0, which a data sheet cannot
// express.
TEST_F(ToolSheet, ErrorCountIsLimitedToTheListLengthInEdsJsonMarkdownAndXdd) {
    EXPECT_THAT(eds(), HasSubstr(crlf("ParameterName=Number of errors\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\n"
                                      "DefaultValue=0\nLowLimit=0\nHighLimit=4\n")));
    const auto json = nlohmann::json::parse(write_object_json(box()));
    EXPECT_EQ(json.at("objects").at(0).at("entries").at(0).at("maximum"), 4);
    EXPECT_THAT(write_object_markdown(box()), HasSubstr("| 0 … 4 |"));
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(write_xdd(loaded_.content, box()).c_str()));
    const auto count = document.select_node("//CANopenObject[@index='1003']/CANopenSubObject[@subIndex='00']").node();
    EXPECT_STREQ(count.attribute("highLimit").value(), "4");
}

// CiA 301, 7.5.2.4: a write of 0 empties the list, any other value is refused.
TEST_F(ToolSheet, ErrorListOfADataSheetAcceptsAWriteOfZeroOnly) {
    const EdsResult read = read_eds(eds(), "box.eds");
    ASSERT_TRUE(read.faults.empty());
    for (const Object& object : read.part.objects) {
        if (object.index == 0x1003) {
            ASSERT_EQ(object.entries.front().range.values.size(), 1U);
            EXPECT_EQ(object.entries.front().range.values.front(), Value{std::int64_t{0}});
        }
    }
}

// 1.5 is 3FC00000h, -2 is C0000000h, 8 is 41000000h as REAL32 (IEEE 754).
TEST_F(ToolSheet, SheetWithDecimalReal32OmitsItsLimits_AndOptionRealsBitsKeepsThem) {
    EXPECT_THAT(eds(), HasSubstr(crlf("DataType=0x0008\nAccessType=rw\nDefaultValue=1.5\nPDOMapping=0\n")));
    EXPECT_THAT(eds(Reals::bits), HasSubstr(crlf("DataType=0x0008\nAccessType=rw\nDefaultValue=0x3FC00000\n"
                                                 "LowLimit=0xC0000000\nHighLimit=0x41000000\nPDOMapping=0\n")));
}

TEST_F(ToolSheet, Real32WithoutLimitsHasNoRange) {
    const EdsResult read = read_eds(eds(), "box.eds");
    ASSERT_TRUE(read.faults.empty());
    EXPECT_TRUE(read.part.objects.back().entries.front().range.empty());
}

}  // namespace canproof::host::test
