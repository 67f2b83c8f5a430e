// SPDX-License-Identifier: Apache-2.0
// Acceptance filters of a node, one test per kind of dictionary entry that names an identifier.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host/datasheet/read_eds.hpp"
#include "host/sim/bus/acceptance.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/host/datasheet/box_eds.hpp"

namespace canproof::host::test {

namespace {

constexpr unsigned node_id = 5;

std::string variable(unsigned index, std::uint32_t value) {
    return fmt::format(
        "[{0:X}]\nParameterName=Object {0:X}\nObjectType=0x7\nDataType=0x0007\nAccessType=rw\nDefaultValue=0x{1:X}\n",
        index, value);
}

/// Returns an object as EDS text. Its sub-index 0 contains the number of values that follow.
std::string record(unsigned index, const std::vector<std::uint32_t>& values) {
    std::string text = fmt::format(
        "[{0:X}]\nParameterName=Object {0:X}\nObjectType=0x8\nSubNumber={1}\n[{0:X}sub0]\nParameterName=Number\n"
        "DataType=0x0005\nAccessType=const\nDefaultValue={2}\n",
        index, values.size() + 1, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += fmt::format(
            "[{0:X}sub{1:X}]\nParameterName=Value {1:X}\nDataType=0x0007\nAccessType=rw\nDefaultValue=0x{2:X}\n", index,
            i + 1, values[i]);
    }
    return text;
}

/// Returns the filters of a device that has only these objects.
std::vector<AcceptanceFilter> filters_with(const std::vector<std::pair<unsigned, std::string>>& objects,
                                           std::uint8_t as_node = node_id) {
    std::string text = box;
    std::string sections;
    std::string list = fmt::format("SupportedObjects={}\n1=0x1017\n2=0x6200\n", objects.size() + 2);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        list += fmt::format("{}=0x{:X}\n", i + 3, objects[i].first);
        sections += objects[i].second;
    }
    text = replaced(text, "SupportedObjects=4\n1=0x1017\n2=0x1400\n3=0x1600\n4=0x6200\n", list);
    const auto from = text.find("[1400]");
    text.erase(from, text.find("[6200]") - from);
    text = replaced(text, "[ManufacturerObjects]", sections + "[ManufacturerObjects]");
    GenericSimulation device{read_eds(text, "box.eds").part};
    device.set_node_id(node_id);
    device.power_on(Instant{});
    return acceptance_filters(*device.objects(), as_node);
}

/// Returns each filter as `703` or `00010205`. Every filter must compare all bits of the identifier.
std::vector<std::string> names(const std::vector<AcceptanceFilter>& filters) {
    std::vector<std::string> all;
    for (const AcceptanceFilter& one : filters) {
        EXPECT_EQ(one.mask, one.extended ? 0x1FFFFFFFU : 0x7FFU);
        all.push_back(one.extended ? fmt::format("{:08X}", one.id) : fmt::format("{:03X}", one.id));
    }
    return all;
}

using Names = std::vector<std::string>;

}  // namespace

TEST(AcceptanceEntries, NodeWithANodeIdAcceptsNmtLssGuardingAndItsSdo) {
    EXPECT_EQ(names(filters_with({})), (Names{"000", "7E5", "705", "605"}));
}

TEST(AcceptanceEntries, NodeWithoutANodeIdAcceptsNmtAndLss) {
    const auto objects = std::vector<std::pair<unsigned, std::string>>{{0x1005, variable(0x1005, 0x80)}};
    EXPECT_EQ(names(filters_with(objects, 0)), (Names{"000", "7E5"}));
    EXPECT_EQ(names(filters_with(objects, 255)), (Names{"000", "7E5"}));
    EXPECT_EQ(names(filters_with(objects, 1)), (Names{"000", "7E5", "701", "601", "080"}));
}

TEST(AcceptanceEntries, FlagsInSyncGuardingAndTimeCobIdsAreNoPartOfTheAcceptedIdentifier) {
    EXPECT_EQ(names(filters_with({{0x1005, variable(0x1005, 0x40000081)},
                                  {0x100E, variable(0x100E, 0x707)},
                                  {0x1012, variable(0x1012, 0xC0000101)}})),
              (Names{"000", "7E5", "705", "605", "081", "707", "101"}));
    EXPECT_EQ(names(filters_with({{0x1005, variable(0x1005, 0x20010081)}})).back(), "00010081");
    // bit 29 is clear, so the identifier has 11 bits: 081h
    EXPECT_EQ(names(filters_with({{0x1005, variable(0x1005, 0x00010081)}})).back(), "081");
}

TEST(AcceptanceEntries, SharedIdentifierHasOneFilterPerFormat) {
    EXPECT_EQ(names(filters_with({{0x1005, variable(0x1005, 0x80)}, {0x1012, variable(0x1012, 0x80)}})),
              (Names{"000", "7E5", "705", "605", "080"}));
    // the same number as an 11-bit and as a 29-bit identifier needs two filters
    EXPECT_EQ(names(filters_with({{0x1005, variable(0x1005, 0x80)}, {0x1012, variable(0x1012, 0x20000080)}})),
              (Names{"000", "7E5", "705", "605", "080", "00000080"}));
}

TEST(AcceptanceEntries, ValidSdoServerIdentifiersAreAcceptedAndClientIdentifiersAreNot) {
    EXPECT_EQ(names(filters_with({{0x1200, record(0x1200, {0x60F, 0x58F})},
                                  {0x1201, record(0x1201, {0x621, 0x5A1})},
                                  {0x127F, record(0x127F, {0x622, 0x5A2})},
                                  {0x1280, record(0x1280, {0x623, 0x5A3})}})),
              (Names{"000", "7E5", "705", "605", "60F", "621", "622"}));
    EXPECT_EQ(names(filters_with({{0x1201, record(0x1201, {0x80000621, 0x5A1})}})),
              (Names{"000", "7E5", "705", "605"}));
}

TEST(AcceptanceEntries, IdentifiersOfValidRpdosAndTpdosAreAccepted) {
    EXPECT_EQ(names(filters_with({{0x1400, record(0x1400, {0x205, 255})},
                                  {0x1401, record(0x1401, {0x80000305, 255})},
                                  {0x15FF, record(0x15FF, {0x20010306, 255})},
                                  {0x1600, record(0x1600, {0x62000108})},
                                  {0x1800, record(0x1800, {0x185, 255})},
                                  {0x1801, record(0x1801, {0x80000285, 255})},
                                  {0x19FF, record(0x19FF, {0x40000286, 255})},
                                  {0x1A00, record(0x1A00, {0x62000108})}})),
              (Names{"000", "7E5", "705", "605", "205", "00010306", "185", "286"}));
}

TEST(AcceptanceEntries, HeartbeatOfEveryMonitoredProducerIsAccepted) {
    EXPECT_EQ(names(filters_with({{0x1016, record(0x1016, {0x00060064, 0x00000064, 0x007F0000, 0x00060032})}})),
              (Names{"000", "7E5", "705", "605", "706", "77F"}));
}

TEST(AcceptanceEntries, HeartbeatsOfAll127ProducersMayBeAccepted) {
    std::vector<std::uint32_t> watched(128);  // one more than the 127 entries of CiA 301
    for (std::uint32_t i = 0; i < watched.size(); ++i) {
        watched[i] = (i + 1U) << 16U | 100U;
    }
    watched.back() = 0x00050064U;
    const Names all = names(filters_with({{0x1016, record(0x1016, watched)}}));
    EXPECT_EQ(all.size(), 4U + 126U);  // 705h is also the guarding identifier of the node itself
    EXPECT_EQ(all.back(), "77F");
    EXPECT_EQ(all[4], "701");
}

TEST(AcceptanceEntries, HeartbeatOfAProducerBehindThe127thEntryIsNotAccepted) {
    std::vector<std::uint32_t> watched(128);
    watched[126] = 0x00060064U;
    watched[127] = 0x00070064U;
    EXPECT_EQ(names(filters_with({{0x1016, record(0x1016, watched)}})), (Names{"000", "7E5", "705", "605", "706"}));
}

TEST(AcceptanceFilterText, EachFrameIsAcceptedByTheFilterOfItsFormat) {
    const auto hears = [](const char* text) {
        const Frame frame = parse_frame(text, "test");
        return std::count_if(accept_everything().begin(), accept_everything().end(),
                             [&](const AcceptanceFilter& one) { return one.accepts(frame); });
    };
    EXPECT_EQ(accept_everything().size(), 2U);
    for (const char* text : {"000#", "7FF#R", "00000000#", "1FFFFFFF#"}) {
        EXPECT_EQ(hears(text), 1) << text;
    }
}

TEST(AcceptanceFilterText, FilterComparesTheBitsOfItsMaskAndTheFormat) {
    const AcceptanceFilter one{0x7A3, 0x7F0, false};
    EXPECT_TRUE(one.accepts(parse_frame("7AF#", "test")));
    EXPECT_FALSE(one.accepts(parse_frame("7B3#", "test")));
    EXPECT_FALSE(one.accepts(parse_frame("000007A3#", "test")));
    EXPECT_FALSE(one == (AcceptanceFilter{0x7A2, 0x7F0, false}));
    EXPECT_FALSE(one == (AcceptanceFilter{0x7A3, 0x7FF, false}));
    EXPECT_FALSE(one == (AcceptanceFilter{0x7A3, 0x7F0, true}));
    EXPECT_TRUE(one == (AcceptanceFilter{0x7A3, 0x7F0, false}));
}

}  // namespace canproof::host::test
