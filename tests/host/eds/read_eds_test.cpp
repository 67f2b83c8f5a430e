// An EDS written out by hand, as a device that runs; and every way in which one can be broken, told by line with its
// mend.
#include "host/eds/read_eds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/bus/acceptance.hpp"
#include "host/bus/candump.hpp"
#include "host/cli/built_in.hpp"
#include "host/devices/generic_simulation.hpp"
#include "host/speccompiler/writers.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string box = R"([FileInfo]
FileName=box.eds
; a comment
[DeviceInfo]
VendorName=Nobody
ProductName=Box
OrderCode=B.1
BaudRate_125=1
BaudRate_250=1
LSS_Supported=1
[DummyUsage]
Dummy0005=1
[MandatoryObjects]
SupportedObjects=3
1=0x1000
2=0x1001
3=0x1018
[1000]
ParameterName=Device Type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x191
PDOMapping=0
[1001]
ParameterName=Error Register
DataType=0x0005
AccessType=ro
DefaultValue=0
PDOMapping=1
[1018]
ParameterName=Identity
ObjectType=0x9
SubNumber=2
[1018sub0]
ParameterName=Highest sub-index
DataType=0x0005
AccessType=ro
DefaultValue=1
[1018sub1]
ParameterName=Vendor-ID
DataType=0x0007
AccessType=ro
DefaultValue=0x17
[OptionalObjects]
SupportedObjects=4
1=0x1017
2=0x1400
3=0x1600
4=0x6200
[1017]
ParameterName=Producer heartbeat time
DataType=0x0006
AccessType=rw
DefaultValue=1000
[1400]
ParameterName=RPDO 1
ObjectType=0x9
SubNumber=3
[1400sub0]
ParameterName=Highest
DataType=0x0005
AccessType=const
DefaultValue=2
[1400sub1]
ParameterName=COB-ID
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x200
[1400sub2]
ParameterName=Transmission type
DataType=0x0005
AccessType=rw
DefaultValue=255
[1600]
ParameterName=RPDO 1 mapping
ObjectType=0x8
SubNumber=2
[1600sub0]
ParameterName=Number
DataType=0x0005
AccessType=rw
DefaultValue=1
LowLimit=0
HighLimit=1
[1600sub1]
ParameterName=First
DataType=0x0007
AccessType=rw
DefaultValue=0x62000108
[6200]
ParameterName=Write outputs
ObjectType=0x8
CompactSubObj=2
DataType=0x0005
AccessType=rww
DefaultValue=3
LowLimit=1
HighLimit=0x40
PDOMapping=1
[6200Name]
NrOfEntries=1
2=Second
[6200Value]
NrOfEntries=1
2=0x20
[ManufacturerObjects]
SupportedObjects=3
1=0x2000
2=0x2001
3=0x2002
[2000]
ParameterName=Trim
DataType=0x0003
AccessType=rw
DefaultValue=-5
LowLimit=0xFF9C
HighLimit=100
[2001]
ParameterName=Name
DataType=0x0009
AccessType=rw
DefaultValue=hello
[2002]
ParameterName=Program
ObjectType=0x2
DataType=0x000F
AccessType=rw
)";

std::string texts(const Faults& faults) {
    std::string all;
    for (const Fault& fault : faults) {
        all += fault.text() + "\n";
    }
    return all;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// Line in which `text` first stands.
std::size_t line_of(const std::string& file, const std::string& text) {
    return static_cast<std::size_t>(
        std::count(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(file.find(text)), '\n') + 1);
}

const Entry& entry(const Part& part, unsigned index, unsigned sub) {
    for (const Object& object : part.objects) {
        for (const Entry& one : object.entries) {
            if (object.index == index && one.subindex == sub) {
                return one;
            }
        }
    }
    throw std::out_of_range{"no such entry"};
}

/// The box, switched on as node 5: frames as in a candump log.
class RunningBox : public testing::Test {
  protected:
    explicit RunningBox(const std::string& text = box) {
        EdsResult read = read_eds(text, "box.eds");
        EXPECT_EQ(texts(read.faults), "");
        device = std::make_unique<GenericSimulation>(std::move(read.part));
        device->set_node_id(5);
        device->power_on(now);
        sent();
    }
    std::vector<std::string> sent() {
        std::vector<std::string> all;
        while (!device->queue().empty()) {
            all.push_back(format_frame(device->queue().pop()));
        }
        return all;
    }
    std::vector<std::string> send(const std::string& frame) {
        device->receive(parse_frame(frame, "test"), now);
        return sent();
    }

    Instant now{};
    std::unique_ptr<GenericSimulation> device;
};

}  // namespace

TEST(ReadEds, TakesEveryAttributeOfAnEntry) {
    const EdsResult read = read_eds(box, "folder/box.eds");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_EQ(texts(read.notes), "");
    EXPECT_EQ(read.part.name, "box");
    EXPECT_EQ(read.part.info.title, "Box");
    EXPECT_EQ(read.part.info.vendor, "Nobody");
    EXPECT_TRUE(read.part.info.lss);
    EXPECT_THAT(read.part.info.bit_rates, ElementsAre(125000, 250000));
    ASSERT_EQ(read.part.objects.size(), 10U);
    EXPECT_EQ(read.part.objects.front().index, 0x1000);
    EXPECT_EQ(read.part.objects.back().index, 0x6200);
    const Entry& cob_id = entry(read.part, 0x1400, 1);
    EXPECT_TRUE(cob_id.node_id);
    EXPECT_EQ(std::get<std::int64_t>(cob_id.value), 0x200);
    EXPECT_EQ(cob_id.service, "pdo");
    const Entry& trim = entry(read.part, 0x2000, 0);
    EXPECT_EQ(trim.type, "INTEGER16");
    EXPECT_EQ(to_text(trim.value), "-5");
    EXPECT_EQ(to_text(trim.range.minimum.number), "-100");  // FF9Ch
    EXPECT_EQ(to_text(trim.range.maximum.number), "100");
    EXPECT_TRUE(trim.stored);
    EXPECT_EQ(entry(read.part, 0x1001, 0).mapping, "tpdo");
    EXPECT_EQ(entry(read.part, 0x2002, 0).type, "DOMAIN");
}

TEST(ReadEds, CompactSubObjectsHaveNamesAndValuesOfTheirOwn) {
    const EdsResult read = read_eds(box, "box.eds");
    EXPECT_EQ(to_text(entry(read.part, 0x6200, 0).value), "2");
    EXPECT_EQ(entry(read.part, 0x6200, 1).name, "Write outputs1");
    EXPECT_EQ(to_text(entry(read.part, 0x6200, 1).value), "3");
    EXPECT_EQ(entry(read.part, 0x6200, 2).name, "Second");
    EXPECT_EQ(to_text(entry(read.part, 0x6200, 2).value), "32");
    EXPECT_EQ(entry(read.part, 0x6200, 2).mapping, "rpdo");
    EXPECT_EQ(entry(read.part, 0x6200, 2).access, "rw");
}

TEST(ReadEds, AccessAndMappingAreReadTogether) {
    const auto mapping = [](const std::string& access) {
        const EdsResult read = read_eds(replaced(box, "AccessType=rww", "AccessType=" + access), "box.eds");
        EXPECT_EQ(texts(read.faults), "");
        return entry(read.part, 0x6200, 1).access + " " + entry(read.part, 0x6200, 1).mapping;
    };
    EXPECT_EQ(mapping("rww"), "rw rpdo");
    EXPECT_EQ(mapping("rwr"), "rw tpdo");
    EXPECT_EQ(mapping("rw"), "rw both");
    EXPECT_EQ(mapping("RO"), "ro tpdo");
    EXPECT_EQ(mapping("wo"), "wo rpdo");
    EXPECT_EQ(mapping("const"), "const tpdo");
}

TEST(ReadEds, ConfigurationFileSetsValuesNodeAndBitRate) {
    const std::string dcf = replaced(box, "DefaultValue=-5", "DefaultValue=-5\nParameterValue=7") +
                            "[DeviceComissioning]\nNodeID=0x21\nBaudrate=250\nNodeName=Left\n";
    const EdsResult read = read_eds(dcf, "box.dcf");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_EQ(to_text(entry(read.part, 0x2000, 0).value), "7");
    EXPECT_EQ(read.part.info.node_id, 0x21);
    EXPECT_EQ(read.part.info.bit_rate, 250000);
}

TEST(ReadEds, LineEndsByteOrderMarkAndCaseDoNotMatter) {
    std::string crlf = "\xEF\xBB\xBF";
    for (const char c : box) {
        crlf += c == '\n' ? std::string{"\r\n"} : std::string{c};
    }
    crlf = replaced(crlf, "[1018sub1]", "[1018SUB1]");
    crlf = replaced(crlf, "ParameterName=Trim", "parametername = Trim");
    const EdsResult read = read_eds(crlf, "box.eds");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_EQ(read.part.objects.size(), 10U);
    EXPECT_EQ(to_text(entry(read.part, 0x1018, 1).value), "23");
}

TEST_F(RunningBox, BootsAnswersAndKeepsItsLimits) {
    EXPECT_EQ(device->node_id(), 5);
    EXPECT_THAT(send("605#4000100000000000"), ElementsAre("585#4300100091010000"));
    EXPECT_THAT(send("605#2B00206400000000"), ElementsAre("585#8000206411000906"));  // no sub-index 64h
    EXPECT_THAT(send("605#2B00200064000000"), ElementsAre("585#6000200000000000"));  // 100
    EXPECT_THAT(send("605#2B00200065000000"), ElementsAre("585#8000200031000906"));  // 101 is too high
    EXPECT_THAT(send("605#2B0020009BFF0000"), ElementsAre("585#8000200032000906"));  // -101 is too low
}

TEST_F(RunningBox, PdoOfTheNodeIdReachesItsObject) {
    send("000#0105");
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_THAT(send("205#11"), IsEmpty());
    EXPECT_THAT(send("605#4000620100000000"), ElementsAre("585#4F00620111000000"));
}

TEST_F(RunningBox, HeartbeatComesAtItsDefaultPeriod) {
    EXPECT_EQ(device->next_deadline().us, 1000000U);
    now = device->next_deadline();
    device->advance(now);
    EXPECT_THAT(sent(), ElementsAre("705#7F"));
}

TEST_F(RunningBox, ListensToWhatItsDictionarySays) {
    const auto accepted = acceptance_filters(*device->objects(), 5);
    const auto hears = [&](const char* frame) {
        return std::any_of(accepted.begin(), accepted.end(),
                           [&](const AcceptanceFilter& one) { return one.accepts(parse_frame(frame, "test")); });
    };
    for (const char* frame : {"000#0105", "7E5#04", "605#40", "205#00", "705#R"}) {
        EXPECT_TRUE(hears(frame)) << frame;
    }
    for (const char* frame : {"606#40", "206#00", "585#40", "703#05", "00000205#00"}) {
        EXPECT_FALSE(hears(frame)) << frame;
    }
    send("605#2300140105020080");  // the PDO goes
    const auto without = acceptance_filters(*device->objects(), 5);
    EXPECT_EQ(without.size() + 1, accepted.size());
    EXPECT_EQ(acceptance_filters(*device->objects(), 255).size(), 2U);  // NMT and LSS
}

TEST_F(RunningBox, LssStoresItsNodeIdAcrossAPowerCycle) {
    send("7E5#0401000000000000");
    send("7E5#1122000000000000");  // node-ID 22h
    EXPECT_THAT(send("7E5#1700000000000000"), ElementsAre("7E4#1700000000000000"));
    const std::vector<std::uint8_t> memory = device->memory().bytes();
    GenericSimulation next{read_eds(box, "box.eds").part};
    next.memory().bytes() = memory;
    next.power_on(Instant{});
    EXPECT_EQ(next.node_id(), 0x22);
}

TEST_F(RunningBox, DomainTakesAndGivesBackAProgram) {
    EXPECT_THAT(send("605#2100200009000000").front(), HasSubstr("585#80"));  // 2000h is no domain of nine bytes
    EXPECT_THAT(send("605#2102200009000000"), ElementsAre("585#6002200000000000"));
    EXPECT_THAT(send("605#0001020304050607"), ElementsAre("585#2000000000000000"));
    EXPECT_THAT(send("605#1B08090000000000"), ElementsAre("585#3000000000000000"));
    EXPECT_THAT(send("605#4002200000000000"), ElementsAre("585#4102200009000000"));
    EXPECT_THAT(send("605#6000000000000000"), ElementsAre("585#0001020304050607"));
    EXPECT_THAT(send("605#7000000000000000"), ElementsAre("585#1B08090000000000"));
}

TEST(BrokenEds, EveryFaultIsToldAtOnceWithLineAndMend) {
    std::string text = box;
    text = replaced(text, "DefaultValue=0x191", "DefaultValue=0x1G1");
    text = replaced(text, "AccessType=ro\nDefaultValue=0\n", "AccessType=readonly\nDefaultValue=0\n");
    text = replaced(text, "DataType=0x0006", "DataType=0x0077");
    text = replaced(text, "DefaultValue=$NODEID+0x200", "DefaultValue=$NODEID*2");
    text = replaced(text, "LowLimit=0xFF9C", "LowLimit=200");
    text = replaced(text, "3=0x2002", "3=0x2002\n4=0x2FFF\n5=banana\n6=0x2001");
    text += "what is this\n";
    const EdsResult read = read_eds(text, "bad.eds");
    const auto at = [&](const std::string& where) { return "bad.eds:" + std::to_string(line_of(text, where)) + ": "; };
    const std::string told = texts(read.faults);
    EXPECT_THAT(told, HasSubstr(at("DefaultValue=0x1G1") + "value 0x1G1 is none of UNSIGNED32; write a whole number"));
    EXPECT_THAT(told, HasSubstr(at("AccessType=readonly") + "AccessType readonly is unknown; use ro"));
    EXPECT_THAT(told, HasSubstr(at("DataType=0x0077") + "DataType 0x0077 is none of an entry; use"));
    EXPECT_THAT(told, HasSubstr(at("DefaultValue=$NODEID*2") + "value $NODEID*2 is none of UNSIGNED32; write"));
    EXPECT_THAT(told, HasSubstr(at("LowLimit=200") + "LowLimit 200 lies above HighLimit 100; swap"));
    EXPECT_THAT(told, HasSubstr(at("4=0x2FFF") + "object 2FFFh is listed but not described; add"));
    EXPECT_THAT(told, HasSubstr(at("5=banana") + "banana is no index; write"));
    EXPECT_THAT(told, HasSubstr("object 2001h is listed already in line"));
    EXPECT_THAT(told, HasSubstr(at("what is this") + "`what is this` is neither [Section] nor Key=Value"));
    EXPECT_EQ(read.faults.size(), 9U) << told;
    EXPECT_TRUE(std::is_sorted(read.faults.begin(), read.faults.end(),
                               [](const Fault& a, const Fault& b) { return a.place.line < b.place.line; }));
}

TEST(BrokenEds, FormOfTheFileIsCheckedLineByLine) {
    const auto told = [](const std::string& text) { return texts(read_eds(text, "x").faults); };
    EXPECT_THAT(told("A=1\n" + box), HasSubstr("x:1: A stands before the first section"));
    EXPECT_THAT(told("[]\n" + box), HasSubstr("x:1: `[]` is no section"));
    EXPECT_THAT(told("[Open\n" + box), HasSubstr("x:1: `[Open` is no section"));
    EXPECT_THAT(told(box + "[1000]\n"), HasSubstr("section [1000] stands already in line 18"));
    EXPECT_THAT(told(replaced(box, "OrderCode=B.1", "OrderCode=B.1\nordercode=C")),
                HasSubstr("ordercode stands already in line 7"));
    EXPECT_THAT(told("; \n" + std::string(9000, 'a') + "\n" + box), HasSubstr("x:2: line is too long"));
    EXPECT_THAT(told(std::string("[A]\nb=\x01\n")), HasSubstr("x:2: line holds control characters"));
    EXPECT_THAT(told(std::string("\0\0\0\0", 4)), HasSubstr("x:1: line holds control characters"));
    EXPECT_THAT(told(""), HasSubstr("the file lists no objects"));
    EXPECT_THAT(told(box + "[1018sub01]\nDataType=5\nAccessType=ro\n"), HasSubstr("describes the same entry"));
}

TEST(BrokenEds, WhatIsMissingInAnEntryIsNamed) {
    const auto told = [](const std::string& from, const std::string& to) {
        return texts(read_eds(replaced(box, from, to), "x").faults);
    };
    EXPECT_THAT(told("DataType=0x0003\n", ""), HasSubstr("[2000] has no DataType"));
    EXPECT_THAT(told("AccessType=rw\nDefaultValue=-5", "DefaultValue=-5"), HasSubstr("[2000] has no AccessType"));
    EXPECT_THAT(told("PDOMapping=0", "PDOMapping=maybe"), HasSubstr("PDOMapping maybe is neither 0 nor 1"));
    EXPECT_THAT(told("ObjectType=0x9\nSubNumber=2", "ObjectType=0x3\nSubNumber=2"),
                HasSubstr("ObjectType 3 is unknown"));
    EXPECT_THAT(told("CompactSubObj=2", "CompactSubObj=300"),
                HasSubstr("CompactSubObj 300 is no number from 0 to 254"));
    EXPECT_THAT(told("CompactSubObj=2\n", ""), HasSubstr("[6200] has no sub-objects"));
    EXPECT_THAT(told("BaudRate_125=1", "BaudRate_125=yes"), HasSubstr("BaudRate_125 yes is neither 0 nor 1"));
    EXPECT_THAT(told("HighLimit=100", "HighLimit=40000"), HasSubstr("HighLimit 40000 is no value of INTEGER16"));
}

TEST(BrokenEds, SloppyFilesRunAndAreToldWhatWasTakenOtherwise) {
    std::string text = replaced(box, "SupportedObjects=3\n1=0x1000", "SupportedObjects=7\n1=0x1000");
    text = replaced(text, "SubNumber=3", "SubNumber=9");
    text = replaced(text, "DefaultValue=-5", "DefaultValue=101");
    text = replaced(text, "ParameterName=Name\n", "");
    text = replaced(text, "DataType=0x0006", "DataType=0x000C");  // TIME_OF_DAY
    text = replaced(text, "DefaultValue=1000", "DefaultValue=");
    text += "[2222]\nParameterName=Forgotten\nDataType=5\nAccessType=ro\n";
    const EdsResult read = read_eds(text, "x");
    EXPECT_EQ(texts(read.faults), "");
    const std::string notes = texts(read.notes);
    EXPECT_THAT(notes, HasSubstr("[MandatoryObjects] lists 3 object(s), not as many as SupportedObjects says"));
    EXPECT_THAT(notes, HasSubstr("SubNumber 9 is not the number of sub-objects, 3"));
    EXPECT_THAT(notes, HasSubstr("value 101 lies outside its limits"));
    EXPECT_THAT(notes, HasSubstr("[2001] has no ParameterName"));
    EXPECT_THAT(notes, HasSubstr("DataType 0x000C is carried as 6 octets"));
    EXPECT_THAT(notes, HasSubstr("[2222] is in none of the lists"));
    EXPECT_EQ(read.notes.size(), 6U) << notes;
}

TEST(BrokenEds, FileThatDescribesMoreThanADeviceCanHoldIsRefused) {
    std::string text = "[ManufacturerObjects]\nSupportedObjects=300\n";
    std::string sections;
    for (int i = 0; i < 300; ++i) {
        text += std::to_string(i + 1) + "=" + std::to_string(0x2000 + i) + "\n";
        char name[16];
        std::snprintf(name, sizeof name, "[%04X]\n", static_cast<unsigned>(0x2000 + i));
        sections += std::string{name} + "ParameterName=A\nObjectType=8\nCompactSubObj=254\nDataType=7\nAccessType=rw\n";
    }
    const std::string told = texts(read_eds(text + sections, "x").faults);
    EXPECT_THAT(told, HasSubstr("entries; at most 65535 can be run"));
    EXPECT_THAT(told, HasSubstr("bytes; at most 65535 can be run"));
}

TEST(BrokenEds, EveryPrefixOfAFileIsReadWithoutHarm) {
    for (std::size_t length = 0; length < box.size(); length += 7) {
        EdsResult read = read_eds(box.substr(0, length), "x");
        if (read.faults.empty()) {
            GenericSimulation device{std::move(read.part)};
            device.power_on(Instant{});
        }
    }
}

TEST(OwnEds, EachDeviceOfTheCatalogueComesBackTheSame) {
    // From [DeviceInfo] on: what stands before it, and the comments, tell of the file and not of the device.
    const auto body = [](std::string text) {
        text.erase(0, text.find("[DeviceInfo]"));
        const auto comments = text.find("[Comments]");
        text.erase(comments, text.find("[MandatoryObjects]") - comments);
        return text;
    };
    int devices = 0;
    for (const Part& part : built_in_register().parts) {
        if (!part.is_device() || part.objects.empty()) {
            continue;
        }
        ++devices;
        const std::string written = write_eds(built_in_register(), part);
        const EdsResult read = read_eds(written, part.name + ".eds");
        EXPECT_EQ(texts(read.faults), "") << part.name;
        EXPECT_EQ(body(write_eds(built_in_register(), read.part)), body(written)) << part.name;
    }
    EXPECT_EQ(devices, 4);
}

}  // namespace canproof::host::test
