// SPDX-License-Identifier: Apache-2.0
// Data sheets of other authors: every fault is reported by line with the assumption that is used, and the device runs;
// a text that is no data sheet is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/host/datasheet/box_eds.hpp"

namespace canproof::host::test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ForeignEds, AllFaultsAreReportedAtOnceWithTheirLineAndTheAssumedValue) {
    std::string text = box;
    text = replaced(text, "DefaultValue=0x191", "DefaultValue=0x1G1");
    text = replaced(text, "AccessType=ro\nDefaultValue=0\n", "AccessType=readonly\nDefaultValue=0\n");
    text = replaced(text, "DataType=0x0006", "DataType=0x0077");
    text = replaced(text, "DefaultValue=$NODEID+0x200", "DefaultValue=$NODEID*2");
    text = replaced(text, "LowLimit=0xFF9C", "LowLimit=200");
    text = replaced(text, "3=0x2002", "3=0x2002\n4=0x2FFF\n5=banana\n6=0x2001");
    text = replaced(text, "SupportedObjects=3\n1=0x2000", "SupportedObjects=6\n1=0x2000");
    text += "what is this\n";
    const EdsResult read = read_eds(text, "bad.eds");
    const auto at = [&](const std::string& where) { return "bad.eds:" + std::to_string(line_of(text, where)) + ": "; };
    EXPECT_EQ(texts(read.faults), "");
    const std::string told = texts(read.notes);
    EXPECT_THAT(told, HasSubstr(at("DefaultValue=0x1G1") + "value 0x1G1 is not of type UNSIGNED32; 0 is assumed"));
    EXPECT_THAT(told, HasSubstr(at("AccessType=readonly") + "AccessType readonly is unknown; rw is assumed"));
    EXPECT_THAT(told, HasSubstr(at("DataType=0x0077") + "DataType 0x0077 is treated as 64 octets; its bytes are not"));
    EXPECT_THAT(told,
                HasSubstr(at("DefaultValue=$NODEID*2") + "value $NODEID*2 is not of type UNSIGNED32; 0 is assumed"));
    EXPECT_THAT(told, HasSubstr(at("LowLimit=200") + "LowLimit 200 is above HighLimit 100; the type alone limits"));
    EXPECT_THAT(told,
                HasSubstr(at("4=0x2FFF") + "object 2FFFh is listed but not described; the device runs without it"));
    EXPECT_THAT(told, HasSubstr(at("5=banana") + "banana is no index; it is ignored"));
    EXPECT_THAT(told, HasSubstr("object 2001h is already listed in line"));
    EXPECT_THAT(told,
                HasSubstr(at("what is this") + "`what is this` is neither [Section] nor Key=Value; it is ignored"));
    EXPECT_THAT(told,
                HasSubstr("COB-ID of 1400h:1 is 0, which is the COB-ID of NMT commands; $NODEID+0x200 is assumed"));
    EXPECT_EQ(read.notes.size(), 10U) << told;
    EXPECT_TRUE(std::is_sorted(read.notes.begin(), read.notes.end(),
                               [](const Fault& a, const Fault& b) { return a.place.line < b.place.line; }));
    GenericSimulation device{read.part};
    device.power_on(Instant{});
    EXPECT_EQ(device.state(), NmtState::pre_operational);
}

TEST(ForeignEds, SyntaxOfTheFileIsCheckedLineByLine) {
    const auto told = [](const std::string& text) {
        const EdsResult read = read_eds(text, "x");
        return texts(read.faults) + texts(read.notes);
    };
    EXPECT_THAT(told("A=1\n" + box), HasSubstr("x:1: key A is before the first section; it is ignored"));
    EXPECT_THAT(told("[]\nA=1\nB\n" + box),
                StartsWith("x:1: `[]` is no name of a section; it is ignored with the lines below it\n"));
    EXPECT_EQ(read_eds("[]\nA=1\nB\n" + box, "x").notes.size(), 1U);
    EXPECT_THAT(told("[Open\n" + box), HasSubstr("x:1: `[Open` is no name of a section"));
    EXPECT_THAT(told("[FileInfo] C1\n" + box), HasSubstr("x:1: `C1` follows the name of the section; it is ignored"));
    EXPECT_EQ(told("# a comment\n[Tools] ; another\n" + box), "");
    EXPECT_THAT(told(replaced(box, "OrderCode=B.1", "OrderCode=B.1\nordercode=C")),
                HasSubstr("key ordercode is already in line 7; the first counts"));
    EXPECT_THAT(told("; \n" + std::string(9000, 'a') + "\n" + box),
                HasSubstr("x:2: line has more than 8192 characters; it is ignored"));
    EXPECT_THAT(told("[A]\nb=\x01\n" + box), HasSubstr("x:2: line contains control characters; it is ignored"));
    EXPECT_THAT(told(box + "[1018sub01]\nDataType=5\nAccessType=ro\n"),
                HasSubstr("[1018sub01] describes the same entry as [1018sub1]; the first counts"));
}

TEST(ForeignEds, RepeatedSectionIsMerged) {
    const EdsResult read = read_eds(box + "[2000]\nHighLimit=7\nPDOMapping=1\n", "x");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_THAT(texts(read.notes), HasSubstr("section [2000] is already in line " +
                                             std::to_string(line_of(box, "[2000]")) + "; both are combined"));
    EXPECT_THAT(texts(read.notes), HasSubstr("key HighLimit is already in line"));
    EXPECT_EQ(to_text(entry(read.part, 0x2000, 0).range.maximum.number), "100");
    EXPECT_EQ(entry(read.part, 0x2000, 0).mapping, "both");
}

TEST(ForeignEds, KeysOfALongListMayHaveAnyOrderAndTheFirstOfEqualKeysCounts) {
    constexpr unsigned count = 40;
    std::string text =
        fmt::format("[DeviceInfo]\nProductName=Many\n[ManufacturerObjects]\nSupportedObjects={}\n", count);
    for (unsigned key = count; key > 0; --key) {  // key 40 is in line 5, so key 7 is in line 5 + 40 - 7 = 38
        text += fmt::format("{}=0x{:04X}\n", key, 0x2000 + key);
    }
    text += "7=0x3000\n";  // line 5 + 40 = 45
    for (unsigned key = 1; key <= count; ++key) {
        text += fmt::format("[{:04X}]\nDataType=5\nPARAMETERNAME=Value {}\nAccessType=rw\n", 0x2000 + key, key);
    }
    const EdsResult read = read_eds(text, "x");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_THAT(texts(read.notes), HasSubstr("x:45: key 7 is already in line 38; the first counts"));
    EXPECT_THAT(texts(read.notes), Not(HasSubstr("3000h")));
    ASSERT_EQ(read.part.objects.size(), count);
    EXPECT_EQ(read.part.objects[6].index, 0x2007);
    EXPECT_EQ(read.part.objects[6].name, "Value 7");
}

TEST(ForeignEds, MissingOrInvalidAttributesOfAnEntryGetAnAssumedValue) {
    const auto told = [](const std::string& from, const std::string& to) {
        const EdsResult read = read_eds(replaced(box, from, to), "x");
        return texts(read.faults) + texts(read.notes);
    };
    EXPECT_THAT(told("DataType=0x0003\n", ""), HasSubstr("[2000] has no DataType; INTEGER32 is assumed"));
    EXPECT_THAT(told("Vendor-ID\nDataType=0x0007", "Vendor-ID"),
                HasSubstr("[1018sub1] has no DataType; UNSIGNED32 is assumed"));
    EXPECT_THAT(told("DataType=0x0009\n", ""), HasSubstr("[2001] has no DataType; VISIBLE_STRING is assumed"));
    EXPECT_THAT(told("DataType=0x0003\n", "DataType=INTEGER16\n"),
                HasSubstr("DataType INTEGER16 is not a number; INTEGER16 is assumed"));
    EXPECT_THAT(told("Highest sub-index\nDataType=0x0005", "Highest sub-index"),
                HasSubstr("[1018sub0] has no DataType; UNSIGNED8 is assumed"));
    EXPECT_THAT(told("AccessType=rw\nDefaultValue=-5", "DefaultValue=-5"),
                HasSubstr("[2000] has no AccessType; rw is assumed"));
    EXPECT_THAT(told("PDOMapping=0", "PDOMapping=maybe"),
                HasSubstr("PDOMapping maybe is neither 0 nor 1; 0 is assumed"));
    EXPECT_THAT(told("PDOMapping=0", "PDOMapping=2"), HasSubstr("PDOMapping 2 is neither 0 nor 1; 1 is assumed"));
    EXPECT_THAT(told("ObjectType=0x9\nSubNumber=2", "ObjectType=0x3\nSubNumber=2"),
                HasSubstr("ObjectType 0x3 is unknown; a RECORD of its sub-objects is assumed"));
    EXPECT_THAT(told("ObjectType=0x9\nSubNumber=2", "SubNumber=2"),
                HasSubstr("[1018] is a single value without DataType; a RECORD of its sub-objects is assumed"));
    EXPECT_THAT(told("CompactSubObj=2", "CompactSubObj=300"),
                HasSubstr("CompactSubObj 300 is not a number from 0 to 254; 0 is assumed"));
    EXPECT_THAT(told("CompactSubObj=2\n", ""), HasSubstr("[6200] has no sub-objects; a VAR is assumed"));
    EXPECT_THAT(told("CompactSubObj=2\nDataType=0x0005\n", ""),
                HasSubstr("[6200] has no sub-objects; the device runs without object 6200h"));
    EXPECT_THAT(told("BaudRate_125=1", "BaudRate_125=yes"), HasSubstr("BaudRate_125 yes is neither 0 nor 1; 0 is"));
    EXPECT_THAT(told("HighLimit=100", "HighLimit=40000"),
                HasSubstr("HighLimit 40000 is no value of type INTEGER16; the type alone limits the value"));
    EXPECT_THAT(told("DefaultValue=hello", "DefaultValue=" + std::string(5000, 'x')),
                HasSubstr("text has 5000 characters; the first 4096 are used"));
}

TEST(ForeignEds, InvalidNodeIdAndBitRateAreReplacedByDefaults) {
    const EdsResult read = read_eds(box + "[DeviceComissioning]\nNodeID=0xff\nBaudrate=0\n", "x");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_THAT(texts(read.notes), HasSubstr("NodeID 0xff is not a number from 1 to 127; 1 is assumed"));
    EXPECT_THAT(texts(read.notes), HasSubstr("BaudRate 0 is not a number from 10 to 1000; 125 is assumed"));
    EXPECT_EQ(read.part.info.node_id, 1);
    EXPECT_EQ(read.part.info.bit_rate, 125000);
}

TEST(ForeignEds, ObjectMissingInTheObjectListsIsReadWithANote) {
    const EdsResult read = read_eds(replaced(box, "3=0x2002\n", ""), "x");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_THAT(texts(read.notes), HasSubstr("[2002] is in none of the lists of objects; the device has the object"));
    EXPECT_EQ(entry(read.part, 0x2002, 0).type, "DOMAIN");
    const EdsResult none = read_eds("[2000]\nDataType=5\nAccessType=rw\nDefaultValue=7\n", "x");
    EXPECT_EQ(texts(none.faults), "");
    EXPECT_EQ(to_text(entry(none.part, 0x2000, 0).value), "7");
}

TEST(ForeignEds, MissingOrZeroCobIdIsReplacedByItsDefaultOrIsInvalid) {
    const std::string rest = "DataType=7\nAccessType=rw\n";
    std::string text = "[1005]\n" + rest + "[100E]\n" + rest + "DefaultValue=0\n[1014]\n" + rest;
    for (const char* index : {"1400", "1403", "1404", "1800", "1803", "1804"}) {
        text += fmt::format("[{}]\nObjectType=9\n[{}sub1]\n", index, index) + rest;
    }
    text += "[1805]\nObjectType=9\n[1805sub1]\n" + rest + "DefaultValue=0x80000000\n";
    const EdsResult read = read_eds(text, "x");
    EXPECT_EQ(texts(read.faults), "");
    const auto cob_id = [&](unsigned index, unsigned sub) {
        const Entry& one = entry(read.part, index, sub);
        return fmt::format("{}{:X}", one.node_id ? "node-ID + " : "", std::get<std::int64_t>(one.value));
    };
    // the expected values are those of the pre-defined connection set in CiA 301
    EXPECT_EQ(cob_id(0x1005, 0), "80");
    EXPECT_EQ(cob_id(0x100E, 0), "node-ID + 700");
    EXPECT_EQ(cob_id(0x1014, 0), "node-ID + 80");
    EXPECT_EQ(cob_id(0x1400, 1), "node-ID + 200");
    EXPECT_EQ(cob_id(0x1403, 1), "node-ID + 500");
    EXPECT_EQ(cob_id(0x1404, 1), "80000000");
    EXPECT_EQ(cob_id(0x1800, 1), "node-ID + 180");
    EXPECT_EQ(cob_id(0x1803, 1), "node-ID + 480");
    EXPECT_EQ(cob_id(0x1804, 1), "80000000");
    EXPECT_EQ(cob_id(0x1805, 1), "80000000");
    EXPECT_THAT(texts(read.notes), HasSubstr("x:" + std::to_string(line_of(text, "DefaultValue=0\n")) +
                                             ": COB-ID of 100Eh:0 is 0, which is the COB-ID of NMT commands; "
                                             "$NODEID+0x700 is assumed"));
    EXPECT_THAT(texts(read.notes), Not(HasSubstr("1805h:1")));
}

TEST(ForeignEds, InvalidLimitAllowsTheWholeRangeOfTheType) {
    std::string text = replaced(box, "DataType=0x0003", "DataType=0x0008");  // REAL32
    text = replaced(text, "DefaultValue=-5", "DefaultValue=0x3FC00000");     // 1.5
    text = replaced(text, "LowLimit=0xFF9C\nHighLimit=100", "LowLimit=-2.5\nHighLimit=much");
    GenericSimulation device{read_eds(text, "x").part};
    device.set_node_id(5);
    device.power_on(Instant{});
    device.queue().pop();
    const auto answer = [&](const char* request) {
        device.receive(parse_frame(request, "test"), Instant{});
        return format_frame(device.queue().pop());
    };
    EXPECT_EQ(answer("605#23002000FFFF7F7F"), "585#6000200000000000");  // the largest float is accepted
    EXPECT_EQ(answer("605#23002000000020C0"), "585#6000200000000000");  // -2.5 is accepted
    EXPECT_EQ(answer("605#23002000000040C0"), "585#8000200032000906");  // -3 is too low
}

TEST(ForeignEds, SheetWithErrorsIsRead_AndEachAssumptionIsReported) {
    std::string text = replaced(box, "SupportedObjects=3\n1=0x1000", "SupportedObjects=7\n1=0x1000");
    text = replaced(text, "SubNumber=3", "SubNumber=9");
    text = replaced(text, "DefaultValue=-5", "DefaultValue=101");
    text = replaced(text, "ParameterName=Name\n", "");
    text = replaced(text, "DataType=0x0006", "DataType=0x000C");  // TIME_OF_DAY
    text = replaced(text, "DefaultValue=1000", "DefaultValue=");
    const EdsResult read = read_eds(text, "x");
    EXPECT_EQ(texts(read.faults), "");
    const std::string notes = texts(read.notes);
    EXPECT_THAT(notes, HasSubstr("[MandatoryObjects] lists 3 object(s), but SupportedObjects has another number"));
    EXPECT_THAT(notes, HasSubstr("SubNumber 9 is not the number of sub-objects, 3"));
    EXPECT_THAT(notes, HasSubstr("value 101 is outside its limits"));
    EXPECT_THAT(notes, HasSubstr("[2001] has no ParameterName"));
    EXPECT_THAT(notes, HasSubstr("DataType 0x000C is treated as 6 octets"));
    EXPECT_EQ(read.notes.size(), 5U) << notes;
}

TEST(BrokenEds, TextThatIsNoDataSheetIsRefused) {
    const auto told = [](const std::string& text) { return texts(read_eds(text, "x").faults); };
    EXPECT_EQ(told(""), "x:1: the file describes no objects; name an EDS, DCF or XDD file\n");
    EXPECT_EQ(told("[FileInfo]\nFileName=x\n"), "x:1: the file describes no objects; name an EDS, DCF or XDD file\n");
    EXPECT_EQ(told(std::string("\0\0\0\0", 4)), "x:1: the file describes no objects; name an EDS, DCF or XDD file\n");
    std::string lines = box;
    for (int i = 0; i < 1000; ++i) {
        lines += "what is this\n";
    }
    EXPECT_EQ(told(lines), "");
    EXPECT_EQ(told(lines + "what is this\n"),
              "x:1: more than 1000 lines are neither [Section] nor Key=Value; name an EDS, DCF or XDD file\n");
}

TEST(BrokenEds, SheetTooLargeForADeviceIsRefused) {
    std::string text = "[ManufacturerObjects]\nSupportedObjects=300\n";
    std::string sections;
    for (int i = 0; i < 300; ++i) {
        text += std::to_string(i + 1) + "=" + std::to_string(0x2000 + i) + "\n";
        char name[16];
        std::snprintf(name, sizeof name, "[%04X]\n", static_cast<unsigned>(0x2000 + i));
        sections += std::string{name} + "ParameterName=A\nObjectType=8\nCompactSubObj=254\nDataType=7\nAccessType=rw\n";
    }
    const std::string told = texts(read_eds(text + sections, "x").faults);
    EXPECT_THAT(told, HasSubstr("entries; remove objects: a device can have at most 65535 entries"));
    EXPECT_THAT(told, HasSubstr("bytes; remove objects: a device can have at most 65535 bytes of values"));
}

TEST(BrokenEds, TruncatedFilesAreReadWithoutACrash) {
    for (std::size_t length = 0; length < box.size(); length += 7) {
        EdsResult read = read_eds(box.substr(0, length), "x");
        if (read.faults.empty()) {
            GenericSimulation device{std::move(read.part)};
            device.power_on(Instant{});
        }
    }
}

}  // namespace canproof::host::test
