// SPDX-License-Identifier: Apache-2.0
// Device descriptions of CiA 311 in XML as running devices: 1.0 with values in attributes, 1.1 with values in
// parameters; and faults in descriptions of other authors.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/datasheet/write_xdd.hpp"
#include "host/register/literals.hpp"
#include "host/selection/built_in.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/host/datasheet/box_eds.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string box_1_0 = R"(<?xml version="1.0" encoding="utf-8"?>
<ISO15745ProfileContainer xmlns="http://www.canopen.org/xml/1.0">
 <ISO15745Profile><ProfileBody>
  <DeviceIdentity>
   <vendorName> Nobody </vendorName>
   <productName>Box</productName>
   <orderNumber>B.1</orderNumber>
  </DeviceIdentity>
 </ProfileBody></ISO15745Profile>
 <ISO15745Profile><ProfileBody>
  <ApplicationLayers><CANopenObjectList>
   <CANopenObject index="1000" name="Device Type" objectType="7" dataType="0007" accessType="ro"
                  defaultValue="0x191" PDOmapping="no"/>
   <CANopenObject index="1018" name="Identity" objectType="9" subNumber="2">
    <CANopenSubObject subIndex="00" name="Highest" objectType="7" dataType="0005" accessType="ro" defaultValue="1"/>
    <CANopenSubObject subIndex="01" name="Vendor-ID" objectType="7" dataType="0007" accessType="ro"
                      defaultValue="0x17"/>
   </CANopenObject>
   <CANopenObject index="1400" name="RPDO 1" objectType="9" subNumber="2">
    <CANopenSubObject subIndex="01" name="COB-ID" dataType="0007" accessType="rw" defaultValue="$NODEID+0x200"/>
   </CANopenObject>
   <CANopenObject index="2000" name="Trim" objectType="7" dataType="0003" accessType="rw" defaultValue="-5"
                  lowLimit="-100" highLimit="100" PDOmapping="RPDO"/>
   <CANopenObject index="0x2001" name="Level" objectType="7" dataType="0x0005" accessType="rw" PDOmapping="optional"/>
  </CANopenObjectList></ApplicationLayers>
  <TransportLayers><PhysicalLayer><baudRate defaultValue="250 Kbps">
   <supportedBaudRate value="125 Kbps"/><supportedBaudRate value="250 Kbps"/><supportedBaudRate value="auto-baudRate"/>
  </baudRate></PhysicalLayer></TransportLayers>
  <NetworkManagement><CANopenGeneralFeatures layerSettingServiceSlave="true"/></NetworkManagement>
 </ProfileBody></ISO15745Profile>
</ISO15745ProfileContainer>
)";

const std::string box_1_1 = R"(<?xml version="1.0"?>
<c:ISO15745ProfileContainer xmlns:c="http://www.canopen.org/xml/1.1">
 <c:ApplicationProcess>
  <c:dataTypeList>
   <c:array name="A" uniqueID="T1"><c:subrange lowerLimit="0" upperLimit="1"/><c:UINT/></c:array>
   <c:struct name="S" uniqueID="T2"/>
   <c:derived name="D" uniqueID="T3"><c:dataTypeIDRef uniqueIDRef="T3"/></c:derived>
  </c:dataTypeList>
  <c:templateList>
   <c:parameterTemplate uniqueID="P0" access="readWriteOutput"><c:SINT/><c:defaultValue value="3"/>
    <c:allowedValues><c:range><c:minValue value="-7"/><c:maxValue value="9"/></c:range></c:allowedValues>
   </c:parameterTemplate>
  </c:templateList>
  <c:parameterList>
   <c:parameter uniqueID="P1"><label lang="en">Device type</label><c:UDINT/><c:defaultValue value="401"/></c:parameter>
   <c:parameter uniqueID="P2" access="readWrite"><c:dataTypeIDRef uniqueIDRef="T1"/><c:defaultValue value="1000"/>
    <c:actualValue value="500"/></c:parameter>
   <c:parameter uniqueID="P3" templateIDRef="P0"/>
   <c:parameter uniqueID="P4" access="noAccess"><c:dataTypeIDRef uniqueIDRef="T3"/></c:parameter>
  </c:parameterList>
 </c:ApplicationProcess>
 <c:CANopenObjectList>
  <c:CANopenObject index="1000" name="" objectType="7" PDOmapping="no" uniqueIDRef="P1"/>
  <c:CANopenObject index="1017" name="Heartbeat" objectType="7" uniqueIDRef="P2"/>
  <c:CANopenObject index="2000" name="Trim" objectType="7" PDOmapping="default" uniqueIDRef="P3"/>
  <c:CANopenObject index="2001" name="Round" objectType="7" uniqueIDRef="P4"/>
  <c:CANopenObject index="2002" name="Lost" objectType="7" uniqueIDRef="P9"/>
 </c:CANopenObjectList>
 <c:deviceCommissioning nodeID="33" actualBaudRate="500 Kbps"/>
</c:ISO15745ProfileContainer>
)";

/// Returns every object and entry as text, without limits of real numbers, because a data sheet in INI form has none.
std::string described(const Part& part) {
    std::string all;
    for (const Object& object : part.objects) {
        all += fmt::format("{:04X} {} {}\n", object.index, object.name, static_cast<int>(object.kind));
        for (const Entry& one : object.entries) {
            const bool limits = !is_real_type(one.type);
            all += fmt::format(" {} {} {} {} {}{} {} [{}, {}] {}\n", one.subindex, one.name, one.type, one.access,
                               one.node_id ? "node-ID + " : "", to_text(one.value), one.mapping,
                               limits ? to_text(one.range.minimum.number) : "",
                               limits ? to_text(one.range.maximum.number) : "", one.length);
        }
    }
    return all;
}

}  // namespace

TEST(ReadXdd, ValuesInAttributesAreReadAsInVersion1_0) {
    const EdsResult read = read_eds(box_1_0, "folder/box.xdd");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_EQ(texts(read.notes),
              "folder/box.xdd:1: object 1001h, which every device must have, is not described; "
              "the device runs without it\n");
    EXPECT_EQ(read.part.name, "box");
    EXPECT_EQ(read.part.info.vendor, "Nobody");
    EXPECT_EQ(read.part.info.title, "Box");
    EXPECT_THAT(read.part.info.part_numbers, ElementsAre("B.1"));
    EXPECT_THAT(read.part.info.bit_rates, ElementsAre(125000, 250000));
    EXPECT_EQ(read.part.info.bit_rate, 250000);
    EXPECT_TRUE(read.part.info.lss);
    EXPECT_EQ(described(read.part),
              "1000 Device Type 7\n 0 Device Type UNSIGNED32 ro 401 none [, ] 0\n"
              "1018 Identity 9\n 0 Highest UNSIGNED8 ro 1 none [, ] 0\n 1 Vendor-ID UNSIGNED32 ro 23 none [, ] 0\n"
              "1400 RPDO 1 9\n 0 Highest sub-index supported UNSIGNED8 ro 1 none [, ] 0\n"
              " 1 COB-ID UNSIGNED32 rw node-ID + 512 none [, ] 0\n"
              "2000 Trim 7\n 0 Trim INTEGER16 rw -5 rpdo [-100, 100] 0\n"
              "2001 Level 7\n 0 Level UNSIGNED8 rw 0 both [, ] 0\n");
    EXPECT_EQ(entry(read.part, 0x2000, 0).place.line, line_of(box_1_0, "index=\"2000\""));
}

TEST(ReadXdd, ValuesInParametersAreReadAsInVersion1_1) {
    const EdsResult read = read_eds(box_1_1, "box.xdc");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_EQ(described(read.part),
              "1000 Device type 7\n 0 Device type UNSIGNED32 ro 401 none [, ] 0\n"
              "1017 Heartbeat 7\n 0 Heartbeat UNSIGNED16 rw 500 none [, ] 0\n"
              "2000 Trim 7\n 0 Trim INTEGER8 rw 3 rpdo [-7, 9] 0\n"
              "2001 Round 7\n 0 Round UNSIGNED32 rw 0 none [, ] 0\n"
              "2002 Lost 7\n 0 Lost UNSIGNED32 rw 0 none [, ] 0\n");
    EXPECT_EQ(read.part.info.node_id, 33);
    EXPECT_EQ(read.part.info.bit_rate, 500000);
    const std::string round = "box.xdc:" + std::to_string(line_of(box_1_1, "index=\"2001\"")) + ": ";
    EXPECT_THAT(texts(read.notes), HasSubstr(round + "AccessType noAccess is unknown; rw is assumed"));
    EXPECT_THAT(texts(read.notes), HasSubstr(round + "[2001] has no DataType; UNSIGNED32 is assumed"));
    const std::string lost = "box.xdc:" + std::to_string(line_of(box_1_1, "index=\"2002\"")) + ": ";
    EXPECT_THAT(texts(read.notes), HasSubstr(lost + "[2002] has no AccessType; rw is assumed"));
}

TEST(ReadXdd, DeviceFromAnXddRunsAndAnswers) {
    GenericSimulation device{read_eds(box_1_0, "box.xdd").part};
    device.set_node_id(5);
    device.power_on(Instant{});
    EXPECT_EQ(format_frame(device.queue().pop()), "705#00");
    device.receive(parse_frame("605#2B00200065000000", "test"), Instant{});
    EXPECT_EQ(format_frame(device.queue().pop()), "585#8000200031000906");  // 101 is too high
}

TEST(ReadXdd, FaultsAreReportedWithTheirLine_AndTheRestIsRead) {
    std::string text = replaced(box_1_0, "index=\"0x2001\"", "index=\"box\"");
    text = replaced(text, "<CANopenObject index=\"2000\"",
                    "<CANopenObject index=\"1018\"/>\n<CANopenObject index=\"2000\"");
    text = replaced(text, "subIndex=\"01\" name=\"Vendor-ID\"", "subIndex=\"100\" name=\"Vendor-ID\"");
    text = replaced(text, "PDOmapping=\"RPDO\"", "PDOmapping=\"often\"");
    text = replaced(text, "subIndex=\"00\" name=\"Highest\"", "subIndex=\"00\" name=\"&#10;[1]&#10;\"");
    const EdsResult read = read_eds("\xEF\xBB\xBF" + text, "x");
    EXPECT_EQ(texts(read.faults), "");
    const auto at = [&](const char* where) { return "x:" + std::to_string(line_of(text, where)) + ": "; };
    const std::string told = texts(read.notes);
    EXPECT_THAT(told, HasSubstr(at("index=\"box\"") + "`box` is no index; it is ignored"));
    EXPECT_THAT(told, HasSubstr(at("index=\"1018\"/>") + "object 1018h is already in line"));
    EXPECT_THAT(told, HasSubstr(at("subIndex=\"100\"") + "`100` is no sub-index; it is ignored"));
    EXPECT_THAT(told, HasSubstr(at("index=\"2000\"") + "PDOMapping often is neither 0 nor 1; 0 is assumed"));
    EXPECT_EQ(entry(read.part, 0x1018, 0).name, "[1]");
}

TEST(ReadXdd, TextThatIsNoXddIsRefused) {
    const auto told = [](const std::string& text) { return texts(read_eds(text, "x").faults); };
    EXPECT_EQ(
        told("<a>\n<b>\n</a>"),
        "x:3: the file is no valid XML: Start-end tags mismatch; correct the XML, or name an EDS, DCF or XDD file\n");
    EXPECT_EQ(told(" <html/>"),
              "x:1: the XML contains no CANopenObjectList of CiA 311; name an EDS, DCF or XDD file\n");
    EXPECT_EQ(told("<CANopenObjectList/>"), "x:1: the file describes no objects; name an EDS, DCF or XDD file\n");
    std::string deep;
    for (int i = 0; i < 1000000; ++i) {
        deep += "<a>";
    }
    EXPECT_THAT(told(deep), HasSubstr("the file is no valid XML: "));
}

TEST(OwnXdd, EachDeviceReadFromItsXddEqualsThatOfItsEds) {
    int devices = 0;
    for (const Part& part : built_in_register().parts) {
        if (!part.is_device() || part.objects.empty()) {
            continue;
        }
        ++devices;
        const EdsResult by_xdd = read_eds(write_xdd(built_in_register(), part), part.name + ".xdd");
        const EdsResult by_eds = read_eds(write_eds(built_in_register(), part), part.name + ".eds");
        EXPECT_EQ(texts(by_xdd.faults) + texts(by_xdd.notes), "") << part.name;
        EXPECT_EQ(described(by_xdd.part), described(by_eds.part));
        EXPECT_EQ(by_xdd.part.info.bit_rates, by_eds.part.info.bit_rates);
        EXPECT_EQ(by_xdd.part.info.lss, by_eds.part.info.lss);
        EXPECT_EQ(by_xdd.part.info.bit_rate, part.info.bit_rate);
    }
    EXPECT_EQ(devices, 4);
}

}  // namespace canproof::host::test
