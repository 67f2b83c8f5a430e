// SPDX-License-Identifier: Apache-2.0
// Tests the object dictionary written as EDS (CiA 306), XDD (CiA 311), JSON and Markdown. The expected texts are
// written by hand for a device `box` with five objects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "host/datasheet/write_dictionary.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/datasheet/write_xdd.hpp"
#include "host/register/load.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

const std::string objects = R"([[object]]
index = 0x1000
name = "Device Type"
type = "UNSIGNED32"
access = "ro"
default = 0x191
source = ["M1:1"]
[[object]]
index = 0x1014
name = "COB-ID EMCY"
type = "UNSIGNED32"
access = "rw"
default = "$NODEID+0x80"
source = ["M1:1"]
[[object]]
index = 0x1018
name = "Identity Object"
source = ["M1:1"]
[[object.entry]]
sub = 1
name = "Vendor-ID"
type = "UNSIGNED32"
access = "ro"
default = 0x17
[[object.entry]]
sub = 2
name = "Product code"
type = "UNSIGNED32"
access = "ro"
default = 0x2345
[[object]]
index = 0x2000
name = "Level"
type = "INTEGER16"
array = 2
access = "rw"
default = [5, -6]
range = { min = -100, max = 90 }
mapping = "rpdo"
source = ["M1:2000h"]
[[object]]
index = 0x6000
name = "Sensor | type"
type = "UNSIGNED8"
access = "rw"
default = 2
range = { values = [8, 2] }
source = ["M1:1"]
)";

class DataSheet : public testing::Test {
  protected:
    DataSheet() : loaded_{load_register(with(items_file, objects))} {}
    void SetUp() override { ASSERT_EQ(all_faults(loaded_), ""); }
    const Part& box() const { return *loaded_.content.part("box"); }
    LoadResult loaded_;
};

}  // namespace

TEST_F(DataSheet, EdsIsWrittenAsCia306Requires) {
    EXPECT_EQ(write_eds(loaded_.content, box()), crlf(R"([FileInfo]
FileName=box.eds
FileVersion=1
FileRevision=0
EDSVersion=4.0
Description=Box 1
CreationTime=12:00AM
CreationDate=02-03-2020
ModificationTime=12:00AM
ModificationDate=02-03-2020
CreatedBy=canproof
ModifiedBy=canproof

[DeviceInfo]
VendorName=Nobody
VendorNumber=0x17
ProductName=Box 1
ProductNumber=0x2345
RevisionNumber=0x0
OrderCode=B.1
BaudRate_10=1
BaudRate_20=0
BaudRate_50=0
BaudRate_125=1
BaudRate_250=0
BaudRate_500=0
BaudRate_800=0
BaudRate_1000=0
SimpleBootUpMaster=0
SimpleBootUpSlave=1
Granularity=0
DynamicChannelsSupported=0
GroupMessaging=0
NrOfRXPDO=0
NrOfTXPDO=0
LSS_Supported=1

[DummyUsage]
Dummy0001=0
Dummy0002=0
Dummy0003=0
Dummy0004=0
Dummy0005=0
Dummy0006=0
Dummy0007=0

[Comments]
Lines=2
Line1=Written by canproof from its register of requirements
Line2=after Small Manual, revision 1.2 of 2020-02-03

[MandatoryObjects]
SupportedObjects=2
1=0x1000
2=0x1018

[1000]
ParameterName=Device Type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x191
PDOMapping=0

[1018]
ParameterName=Identity Object
ObjectType=0x9
SubNumber=3

[1018sub0]
ParameterName=Highest sub-index
ObjectType=0x7
DataType=0x0005
AccessType=const
DefaultValue=2
PDOMapping=0

[1018sub1]
ParameterName=Vendor-ID
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x17
PDOMapping=0

[1018sub2]
ParameterName=Product code
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x2345
PDOMapping=0

[OptionalObjects]
SupportedObjects=2
1=0x1014
2=0x6000

[1014]
ParameterName=COB-ID EMCY
ObjectType=0x7
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x80
PDOMapping=0

[6000]
ParameterName=Sensor | type
ObjectType=0x7
DataType=0x0005
AccessType=rw
DefaultValue=2
LowLimit=2
HighLimit=8
PDOMapping=0

[ManufacturerObjects]
SupportedObjects=1
1=0x2000

[2000]
ParameterName=Level
ObjectType=0x8
SubNumber=3

[2000sub0]
ParameterName=Highest sub-index
ObjectType=0x7
DataType=0x0005
AccessType=const
DefaultValue=2
PDOMapping=0

[2000sub1]
ParameterName=Level 1
ObjectType=0x7
DataType=0x0003
AccessType=rww
DefaultValue=5
LowLimit=-100
HighLimit=90
PDOMapping=1

[2000sub2]
ParameterName=Level 2
ObjectType=0x7
DataType=0x0003
AccessType=rww
DefaultValue=-6
LowLimit=-100
HighLimit=90
PDOMapping=1
)"));
}

TEST_F(DataSheet, XddHasObjectCountsEntryAttributesAndDeviceData) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(write_xdd(loaded_.content, box()).c_str()));
    const auto list = document.select_node("//CANopenObjectList").node();
    EXPECT_STREQ(list.attribute("mandatoryObjects").value(), "2");
    EXPECT_STREQ(list.attribute("optionalObjects").value(), "2");
    EXPECT_STREQ(list.attribute("manufacturerObjects").value(), "1");
    const auto level = document.select_node("//CANopenObject[@index='2000']/CANopenSubObject[@subIndex='02']").node();
    EXPECT_STREQ(level.attribute("dataType").value(), "0003");
    EXPECT_STREQ(level.attribute("defaultValue").value(), "-6");
    EXPECT_STREQ(level.attribute("highLimit").value(), "90");
    EXPECT_STREQ(level.attribute("PDOmapping").value(), "RPDO");
    EXPECT_STREQ(document.select_node("//DeviceIdentity/vendorID").node().text().get(), "0x00000017");
    EXPECT_STREQ(document.select_node("//baudRate").node().attribute("defaultValue").value(), "125 Kbps");
    EXPECT_STREQ(document.select_node("//DeviceFunction//characteristicContent/label").node().text().get(),
                 "Small Manual, revision 1.2 of 2020-02-03");
    // the device `box` has no mapping that can be changed
    EXPECT_STREQ(document.select_node("//CANopenGeneralFeatures").node().attribute("granularity").value(), "0");
}

TEST_F(DataSheet, JsonNamesTypesDefaultsAndLimits) {
    const auto json = nlohmann::json::parse(write_object_json(box()));
    EXPECT_EQ(json.at("device"), "box");
    ASSERT_EQ(json.at("objects").size(), 5U);
    const auto& level = json.at("objects").at(3);
    EXPECT_EQ(level.at("index"), "0x2000");
    EXPECT_EQ(level.at("id"), "AO4-OD-2000");
    EXPECT_EQ(level.at("kind"), "ARRAY");
    EXPECT_EQ(level.at("entries").at(2).at("default"), -6);
    EXPECT_EQ(level.at("entries").at(2).at("minimum"), -100);
    EXPECT_EQ(json.at("objects").at(1).at("entries").at(0).at("default"), "$NODEID+0x80");
    EXPECT_EQ(json.at("objects").at(4).at("entries").at(0).at("values"), nlohmann::json({8, 2}));
}

TEST_F(DataSheet, MarkdownRowHasTheAttributesOfItsEntry) {
    const std::string text = write_object_markdown(box());
    EXPECT_THAT(text, testing::HasSubstr("# Object dictionary of Box 1\n"));
    EXPECT_THAT(text,
                testing::HasSubstr(
                    "| 2000h | 2 | Level: Level 2 | INTEGER16 | rw | -6 | -100 … 90 | rpdo | yes | AO4-OD-2000 |\n"));
    EXPECT_THAT(text, testing::HasSubstr(
                          "| 6000h | 0 | Sensor \\| type | UNSIGNED8 | rw | 2 | 8, 2 |  | yes | AO4-OD-6000 |\n"));
}

}  // namespace canproof::host::test
