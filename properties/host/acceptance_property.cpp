// SPDX-License-Identifier: Apache-2.0
// Checks that the acceptance filters of a simulated node accept all identifiers that occur in its object dictionary. A
// node that receives only the frames that its filters accept must behave like a node that receives every frame.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/run/device_node.hpp"
#include "tests/support/every_device.hpp"

namespace canproof::host {

namespace {

constexpr unsigned node_id = 5;

/// An identifier: (true, number) has 29 bits, (false, number) has 11 bits.
using Identifier = std::pair<bool, std::uint32_t>;

/// Returns the identifier in a COB-ID entry: bit 29 of the entry selects 11 or 29 bits.
Identifier identifier_in(std::uint32_t entry) {
    const bool extended = (entry & 0x20000000U) != 0U;
    return {extended, entry & (extended ? 0x1FFFFFFFU : 0x7FFU)};
}

/// Returns all identifiers that a node may receive by CiA 301 and CiA 305, from the COB-IDs and node-IDs in its
/// dictionary.
std::set<Identifier> heard_identifiers(const ObjectDictionary& objects) {
    std::set<Identifier> heard{{false, 0x000}, {false, 0x7E5}, {false, 0x600 + node_id}, {false, 0x700 + node_id}};
    for (const std::uint16_t index : {std::uint16_t{0x1005}, std::uint16_t{0x100E}, std::uint16_t{0x1012}}) {
        if (objects.has(index, 0)) {
            heard.insert(identifier_in(objects.read(index, 0)));
        }
    }
    const auto add_if_valid = [&](unsigned index) {
        const auto at = static_cast<std::uint16_t>(index);
        if (objects.has(at, 1) && (objects.read(at, 1) & 0x80000000U) == 0U) {
            heard.insert(identifier_in(objects.read(at, 1)));
        }
    };
    for (unsigned server = 0x1200; server <= 0x127F; ++server) {
        add_if_valid(server);
    }
    for (unsigned number = 0; number < 0x200; ++number) {
        add_if_valid(0x1400 + number);
        add_if_valid(0x1800 + number);
    }
    for (unsigned sub = 1; objects.has(0x1016, 0) && sub <= objects.read(0x1016, 0); ++sub) {
        const std::uint32_t producer = objects.read(0x1016, static_cast<std::uint8_t>(sub)) / 0x10000U % 0x80U;
        if (producer != 0U) {
            heard.insert({false, 0x700 + producer});
        }
    }
    return heard;
}

/// Returns an SDO write of a COB-ID or of 1016h (consumer heartbeat time). The device refuses some of these writes.
std::string any_setting() {
    const auto number = *rc::gen::element<std::uint32_t>(0x080, 0x181, 0x185, 0x205, 0x305, 0x701, 0x7FF, 0x10205);
    const auto flags = *rc::gen::element<std::uint32_t>(0, 0, 0x20000000, 0x40000000, 0x80000000, 0xA0000000);
    const auto at = *rc::gen::element<std::string>("051000", "0E1000", "121000", "011201", "001401", "011401", "001801",
                                                   "011801", "021801");
    const bool consumer = *rc::gen::inRange(0, 3) == 0;
    const std::uint32_t value = number | flags;
    const std::string place = consumer ? "16100" + std::to_string(*rc::gen::inRange(1, 4)) : at;
    const std::uint32_t watched = (*rc::gen::inRange<std::uint32_t>(0, 130) << 16U) | 100U;
    std::string text = "605#23" + place;
    for (unsigned i = 0; i < 4; ++i) {
        text += fmt::format("{:02X}", (consumer ? watched : value) >> (8U * i) & 0xFFU);
    }
    return text;
}

/// Returns a write of any_setting(), an NMT command, another request, or a frame of another node. The identifier of
/// that frame, with 11 or 29 bits, is one that a write of any_setting() may have set.
Frame any_traffic() {
    if (*rc::gen::arbitrary<bool>()) {
        return parse_frame(any_setting(), "law");
    }
    static const std::vector<std::string> others{
        "000#0105", "000#8005",     "000#8205", "080#",     "705#R",   "605#4008100000000000",
        "205#FF7F", "305#FF7FFF7F", "185#R",    "701#05",   "711#05",  "701#7F",
        "711#7F",   "7FF#00",       "181#0102", "7E5#0401", "7E5#0400"};
    Frame frame = parse_frame(*rc::gen::elementOf(others), "law");
    frame.extended = *rc::gen::inRange(0, 3) == 0;
    return frame;
}

struct Twin {
    explicit Twin(const std::string& name) : node{name, choose_device(name + "@5").device} { node.power_on(Instant{}); }

    void advance(Instant now) {
        while (node.device().next_deadline() <= now) {
            node.device().advance(node.device().next_deadline());
            collect();
        }
    }
    void collect() {
        while (node.next_frame() != nullptr) {
            sent.push_back(format_frame(*node.next_frame()));
            node.take_frame();
        }
    }
    bool accepts(const Frame& frame) const {
        return std::any_of(node.filters().begin(), node.filters().end(),
                           [&](const AcceptanceFilter& one) { return one.accepts(frame); });
    }

    DeviceNode node;
    std::vector<std::string> sent;
};

}  // namespace

RC_GTEST_PROP(AcceptanceLaw, NodeAcceptsTheIdentifiersOfItsDictionaryAndNoOthers, ()) {
    Twin twin{*rc::gen::elementOf(canproof::test::every_device())};
    for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
        twin.node.receive(parse_frame(any_setting(), "law"), Instant{1000});
        twin.collect();
    }
    const auto entry = *rc::gen::element<std::string>("001401", "011401", "001801", "011801");
    const auto rest = *rc::gen::element<std::string>("85010100", "85010000");
    twin.node.receive(parse_frame("605#23" + entry + "850100A0", "law"),
                      Instant{1000});  // bit 31 makes the PDO not valid, so that its identifier may be changed
    twin.node.receive(parse_frame("605#23" + entry + rest.substr(0, 6) + "20", "law"), Instant{1000});
    twin.collect();
    const std::set<Identifier> heard = heard_identifiers(*twin.node.device().objects());
    const auto check = [&](std::uint32_t id, bool extended) {
        Frame frame{};
        frame.id = id;
        frame.extended = extended;
        RC_ASSERT(twin.accepts(frame) == (heard.count({extended, id}) != 0U));
    };
    for (std::uint32_t id = 0; id <= 0x7FFU; ++id) {
        check(id, false);
        check(id, true);
        check(id | 0x00010000U, true);  // the identifier of 29 bits with the same last eleven bits
        check(id << 18U, true);         // the identifier of 29 bits with the same first eleven bits
    }
}

RC_GTEST_PROP(AcceptanceLaw, NodeBehindItsFiltersBehavesLikeANodeThatReceivesEverything, ()) {
    const auto name = *rc::gen::elementOf(canproof::test::every_device());
    Twin filtered{name};
    Twin open{name};
    Instant now{};
    for (int i = *rc::gen::inRange(1, 40); i > 0; --i) {
        now = now + microseconds(*rc::gen::inRange<std::uint64_t>(0, 120000));
        filtered.advance(now);
        open.advance(now);
        const Frame frame = any_traffic();
        if (filtered.accepts(frame)) {
            filtered.node.receive(frame, now);
        }
        open.node.receive(frame, now);
        filtered.collect();
        open.collect();
        RC_ASSERT(filtered.sent == open.sent);
    }
    RC_ASSERT(filtered.node.device().outputs() == open.node.device().outputs());
}

}  // namespace canproof::host
