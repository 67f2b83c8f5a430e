// SPDX-License-Identifier: Apache-2.0
// Compares the LSS slave with a naive slave: a simple implementation that stores all received requests and evaluates
// them again for each answer.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "generated/canopen/requirements.hpp"
#include "properties/support/naive_lss_slave.hpp"
#include "tests/support/lss_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using naive::address;
using naive::Bytes;
using naive::frame_text;
using naive::with_number;

/// One event on the bus or in the device.
struct Event {
    enum class Kind { lss, nmt, read, pass, store_result, power_cycle };
    Kind kind{Kind::lss};
    Bytes bytes;
    std::uint64_t value{0};
};

std::ostream& operator<<(std::ostream& out, const Event& event) {
    static const std::array<const char*, 6> names{"lss", "nmt", "read", "pass", "store", "power"};
    return out << names[static_cast<std::size_t>(event.kind)] << ' ' << event.value << ' '
               << frame_text(0x7E5, event.bytes);
}

using Events = std::vector<Event>;

std::uint64_t below(std::uint64_t limit) {
    return *rc::gen::inRange<std::uint64_t>(0, limit);
}
/// Returns number `which` (0 to 3) of the slave's LSS address, a number that differs from it by one, or any other
/// number.
std::uint32_t number_near(std::size_t which) {
    const std::uint64_t kind = below(10);
    return kind < 7    ? address[which]
           : kind == 7 ? address[which] + 1
           : kind == 8 ? address[which] - 1
                       : *rc::gen::arbitrary<std::uint32_t>();
}
/// Returns an LSS request. Its length is mostly that of CiA 305 (8 bytes), or the shorter length in the Axiomatic
/// manuals.
Event request(Bytes bytes) {
    const std::uint64_t kind = below(8);
    if (kind < 4) {
        bytes.resize(8);
    } else if (kind == 4) {
        bytes.resize(below(9));
    }
    return {Event::Kind::lss, std::move(bytes), 0};
}

Events selection() {
    Events events;
    for (std::uint8_t i = 0; i < 4; ++i) {
        events.push_back({Event::Kind::lss, with_number(static_cast<std::uint8_t>(0x40 + i), address[i]), 0});
    }
    if (below(3) == 0) {
        const std::size_t at = below(4);
        events[at] = request(with_number(static_cast<std::uint8_t>(0x40 + below(4)), number_near(at)));
    }
    return events;
}
Events identification() {
    Events events;
    for (std::uint8_t i = 0; i < 6; ++i) {
        const std::size_t which = i < 2 ? i : 2 + (i - 2U) / 2;
        const std::uint32_t slack = i < 2 ? 0U : static_cast<std::uint32_t>(below(3));
        const std::uint32_t number = i % 2 == 0 ? address[which] - slack : address[which] + slack;
        events.push_back({Event::Kind::lss, with_number(static_cast<std::uint8_t>(0x46 + i), number), 0});
    }
    if (below(3) == 0) {
        const std::size_t at = below(6);
        events[at] = request(with_number(static_cast<std::uint8_t>(0x46 + below(6)), number_near(below(4))));
    }
    return events;
}
Event scan_request(std::uint8_t which, std::uint8_t next, std::uint8_t check, std::uint32_t number) {
    Bytes bytes = with_number(0x51, number);
    bytes.insert(bytes.end(), {check, which, next});
    return {Event::Kind::lss, std::move(bytes), 0};
}
/// Returns the requests of a Fastscan for the LSS address: complete, in another order, or with a fault.
Events scan() {
    Events events;
    if (below(8) != 0) {
        events.push_back(scan_request(0, 0, 128, 0));
    }
    std::uint8_t which = 0;
    const std::uint64_t steps = 4 + below(4);
    const bool in_order = below(2) == 0;
    for (std::uint64_t i = 0; i < steps; ++i) {
        const auto next = static_cast<std::uint8_t>(in_order ? (which + 1U) % 4U : below(4));
        const auto check = static_cast<std::uint8_t>(below(12) == 0 ? below(34) : 0);
        const std::uint32_t number = below(24) == 0 ? number_near(which) : address[which];
        events.push_back(scan_request(which, next, check, number));
        which = check == 0 ? next : which;
    }
    return events;
}
Events configuration() {
    const auto byte = [](std::uint64_t value) { return static_cast<std::uint8_t>(value); };
    Events events;
    if (below(3) != 0) {
        events.push_back(request({0x04, 1}));
    }
    if (below(2) == 0) {
        events.push_back(request({0x11, byte(below(3) == 0 ? 255 : below(140))}));
    }
    if (below(2) == 0) {
        events.push_back(request({0x13, byte(below(8) == 0 ? 1 : 0), byte(below(11))}));
    }
    if (below(3) == 0) {
        events.push_back(request({0x15, byte(below(20)), 0}));
    }
    if (below(2) == 0) {
        events.push_back(request({0x17}));
    }
    events.push_back(request({byte(0x5A + below(5))}));
    if (below(3) != 0) {
        events.push_back(request({0x04, byte(below(8) == 0 ? 2 : 0)}));
    }
    return events;
}
Events single() {
    switch (below(6)) {
        case 0:
            return {{Event::Kind::nmt, {}, std::array<std::uint64_t, 5>{0x01, 0x02, 0x80, 0x81, 0x82}[below(5)]}};
        case 1:
            return {{Event::Kind::pass, {}, 1 + below(40)}};
        case 2:
            return {{Event::Kind::store_result, {}, below(3)}};
        case 3:
            return {{Event::Kind::power_cycle, {}, 0}};
        case 4:
            return {request({0x4C})};
        default:
            return {request(*rc::gen::container<Bytes>(8, rc::gen::arbitrary<std::uint8_t>()))};
    }
}
Events history() {
    Events events;
    const std::uint64_t phrases = 1 + below(14);
    for (std::uint64_t i = 0; i < phrases; ++i) {
        const std::array<Events (*)(), 6> makers{selection, identification, scan, configuration, scan, single};
        const Events phrase = makers[below(makers.size())]();
        events.insert(events.end(), phrase.begin(), phrase.end());
        events.push_back({Event::Kind::read, {}, 0});
    }
    return events;
}

/// Removes TPDO1 and TPDO2 (180h and 280h + node-ID), which a node sends when it becomes operational.
Frames without_pdos(Frames frames) {
    frames.erase(std::remove_if(frames.begin(), frames.end(),
                                [](const std::string& frame) { return frame[0] == '1' || frame[0] == '2'; }),
                 frames.end());
    return frames;
}

/// Performs the event on the device and on the naive slave. Checks that both send the same frames and have the same
/// state.
void happen(const Event& event, LssBench& bench, naive::LssSlave& naive) {
    switch (event.kind) {
        case Event::Kind::lss:
            RC_ASSERT(bench.send(frame_text(0x7E5, event.bytes)) == naive.lss(event.bytes));
            break;
        case Event::Kind::nmt:
            RC_ASSERT(without_pdos(bench.send(fmt::format("000#{:02X}00", event.value))) ==
                      naive.nmt(static_cast<std::uint8_t>(event.value)));
            break;
        case Event::Kind::read:
            for (const std::uint8_t node : {std::uint8_t{5}, naive.active}) {
                RC_ASSERT(bench.send(fmt::format("{:03X}#4000100000000000", 0x600 + node)) ==
                          naive.read_device_type(node));
            }
            RC_ASSERT(bench.send("7E5#5E") == naive.lss({0x5E}));
            break;
        case Event::Kind::pass:
            RC_ASSERT(bench.pass(event.value).empty());
            naive.pass(event.value);
            break;
        case Event::Kind::store_result:
            bench.device->answer_store_with(std::array<LssError, 3>{LssError::none, LssError::not_supported,
                                                                    LssError::storage_failed}[event.value]);
            naive.store_result = static_cast<std::uint8_t>(event.value);
            break;
        case Event::Kind::power_cycle:
            RC_ASSERT(bench.start(bench.device->stored()) == naive.power_on(naive.stored));
            naive.store_result = 0;
            break;
    }
    RC_ASSERT(bench.bit_rate() == naive.rate);
    RC_ASSERT(bench.device->stored().node_id == naive.stored.node_id);
    RC_ASSERT(bench.device->stored().bit_rate == naive.stored.bit_rate);
    RC_ASSERT(bench.device->node().node_id() == naive.active);
}

}  // namespace

RC_GTEST_PROP(LssLaw, SlaveAnswersLikeTheNaiveModel, ()) {
    verifies<req::CO_LSS_001, req::CO_LSS_002, req::CO_LSS_003, req::CO_LSS_068, req::CO_LSS_069, req::CO_LSS_005,
             req::CO_LSS_006, req::CO_LSS_070, req::CO_LSS_010, req::CO_LSS_071, req::CO_LSS_011, req::CO_LSS_012,
             req::CO_LSS_072, req::CO_LSS_013, req::CO_LSS_014, req::CO_LSS_073, req::CO_LSS_015, req::CO_LSS_074,
             req::CO_LSS_016, req::CO_LSS_075, req::CO_LSS_017, req::CO_LSS_018, req::CO_LSS_031, req::CO_LSS_040,
             req::CO_LSS_041, req::CO_LSS_042, req::CO_LSS_043, req::CO_LSS_077, req::CO_LSS_078, req::CO_LSS_044,
             req::CO_LSS_050, req::CO_LSS_051, req::CO_LSS_052, req::CO_LSS_079, req::CO_LSS_053, req::CO_LSS_054,
             req::CO_LSS_055, req::CO_LSS_060, req::CO_LSS_080, req::CO_LSS_061, req::CO_LSS_081, req::CO_LSS_062,
             req::CO_LSS_063, req::CO_LSS_085>("property");
    const bool resets_itself = *rc::gen::arbitrary<bool>();
    const LssConfiguration first{static_cast<std::uint8_t>(below(3) == 0 ? 5 : 255), 125000};
    LssBench bench;
    bench.resets_itself = resets_itself;
    bench.start(first);
    naive::LssSlave naive{resets_itself, {first.node_id, first.bit_rate}};
    for (const Event& event : *rc::gen::exec(history)) {
        happen(event, bench, naive);
    }
    RC_CLASSIFY(naive.selections > 0, "selected");
    RC_CLASSIFY(naive.scans > 0, "found by Fastscan");
}

}  // namespace canproof::test
