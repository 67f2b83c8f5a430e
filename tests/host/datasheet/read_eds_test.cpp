// SPDX-License-Identifier: Apache-2.0
// Tests a device that runs from a hand-written EDS.
#include "host/datasheet/read_eds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/selection/built_in.hpp"
#include "host/sim/bus/acceptance.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/host/datasheet/box_eds.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The device of box_eds.hpp, powered on with the node-ID 5. Frames are written as in a candump log.
class RunningDevice : public testing::Test {
  protected:
    explicit RunningDevice(const std::string& text = box) {
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

TEST(ReadEds, AttributesOfTheDeviceAndItsEntriesAreRead) {
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
    EXPECT_EQ(to_text(trim.range.minimum.number), "-100");  // FF9Ch in the sheet
    EXPECT_EQ(to_text(trim.range.maximum.number), "100");
    EXPECT_TRUE(trim.stored);
    EXPECT_EQ(entry(read.part, 0x1001, 0).mapping, "tpdo");
    EXPECT_EQ(entry(read.part, 0x2002, 0).type, "DOMAIN");
}

TEST(ReadEds, CompactSubObjectsHaveTheirOwnNamesAndValues) {
    const EdsResult read = read_eds(box, "box.eds");
    EXPECT_EQ(to_text(entry(read.part, 0x6200, 0).value), "2");
    EXPECT_EQ(entry(read.part, 0x6200, 1).name, "Write outputs1");
    EXPECT_EQ(to_text(entry(read.part, 0x6200, 1).value), "3");
    EXPECT_EQ(entry(read.part, 0x6200, 2).name, "Second");
    EXPECT_EQ(to_text(entry(read.part, 0x6200, 2).value), "32");
    EXPECT_EQ(entry(read.part, 0x6200, 2).mapping, "rpdo");
    EXPECT_EQ(entry(read.part, 0x6200, 2).access, "rw");
}

TEST(ReadEds, AccessTypeAlsoSelectsTheDirectionOfMapping) {
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

TEST(ReadEds, ConfigurationFileSetsValuesNodeIdAndBitRate) {
    const std::string dcf = replaced(box, "DefaultValue=-5", "DefaultValue=-5\nParameterValue=7") +
                            "[DeviceComissioning]\nNodeID=0x21\nBaudrate=250\nNodeName=Left\n";
    const EdsResult read = read_eds(dcf, "box.dcf");
    EXPECT_EQ(texts(read.faults), "");
    EXPECT_EQ(to_text(entry(read.part, 0x2000, 0).value), "7");
    EXPECT_EQ(read.part.info.node_id, 0x21);
    EXPECT_EQ(read.part.info.bit_rate, 250000);
}

TEST(ReadEds, LineEndsByteOrderMarkAndCaseAreIgnored) {
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

TEST_F(RunningDevice, DeviceFromAnEdsBootsAnswersAndEnforcesItsLimits) {
    EXPECT_EQ(device->node_id(), 5);
    EXPECT_THAT(send("605#4000100000000000"), ElementsAre("585#4300100091010000"));
    EXPECT_THAT(send("605#2B00206400000000"), ElementsAre("585#8000206411000906"));  // 2000h has no sub-index 64h
    EXPECT_THAT(send("605#2B00200064000000"), ElementsAre("585#6000200000000000"));  // 100 is accepted
    EXPECT_THAT(send("605#2B00200065000000"), ElementsAre("585#8000200031000906"));  // 101 is too high
    EXPECT_THAT(send("605#2B0020009BFF0000"), ElementsAre("585#8000200032000906"));  // -101 is too low
}

TEST_F(RunningDevice, RpdoOnItsDefaultCobIdSetsItsObject) {
    send("000#0105");
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_THAT(send("205#11"), IsEmpty());
    EXPECT_THAT(send("605#4000620100000000"), ElementsAre("585#4F00620111000000"));
}

TEST_F(RunningDevice, HeartbeatIsSentAtItsDefaultPeriod) {
    EXPECT_EQ(device->next_deadline().us, 1000000U);
    now = device->next_deadline();
    device->advance(now);
    EXPECT_THAT(sent(), ElementsAre("705#7F"));
}

TEST_F(RunningDevice, AcceptanceFiltersFollowTheDictionary) {
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
    send("605#2300140105020080");  // the PDO is not valid any more
    const auto without = acceptance_filters(*device->objects(), 5);
    EXPECT_EQ(without.size() + 1, accepted.size());
    EXPECT_EQ(acceptance_filters(*device->objects(), 255).size(), 2U);  // NMT and LSS
}

TEST_F(RunningDevice, LssStoresItsNodeIdAcrossAPowerCycle) {
    send("7E5#0401000000000000");
    send("7E5#1122000000000000");  // node-ID 22h
    EXPECT_THAT(send("7E5#1700000000000000"), ElementsAre("7E4#1700000000000000"));
    const std::vector<std::uint8_t> memory = device->memory().bytes();
    GenericSimulation next{read_eds(box, "box.eds").part};
    next.memory().bytes() = memory;
    next.power_on(Instant{});
    EXPECT_EQ(next.node_id(), 0x22);
}

TEST_F(RunningDevice, DomainStoresAndReturnsAProgram) {
    EXPECT_THAT(send("605#2100200009000000").front(), HasSubstr("585#80"));  // 2000h has two bytes, not nine
    EXPECT_THAT(send("605#2102200009000000"), ElementsAre("585#6002200000000000"));
    EXPECT_THAT(send("605#0001020304050607"), ElementsAre("585#2000000000000000"));
    EXPECT_THAT(send("605#1B08090000000000"), ElementsAre("585#3000000000000000"));
    EXPECT_THAT(send("605#4002200000000000"), ElementsAre("585#4102200009000000"));
    EXPECT_THAT(send("605#6000000000000000"), ElementsAre("585#0001020304050607"));
    EXPECT_THAT(send("605#7000000000000000"), ElementsAre("585#1B08090000000000"));
}

TEST(OwnEds, EachDeviceReadFromItsEdsIsUnchanged) {
    // Keeps the text from [DeviceInfo] on, without [Comments]. The rest describes the file and not the device.
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
