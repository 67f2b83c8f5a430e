// SPDX-License-Identifier: Apache-2.0
// Checks that the outputs of the CAN-CBX-AO412 are equal and independent (manual, 2.4, 7.10 and 7.11). If parameters,
// values and factory calibration of the four outputs are exchanged, their frames and values must be exchanged, and
// nothing else may change.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "generated/cbx_ao412/requirements.hpp"
#include "properties/devices/cbx-ao412/ao4_scenario.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// For each output of the first device, the position of the corresponding output in the second device, counted from 0.
using Places = std::array<unsigned, 4>;

bool has_outputs(unsigned index) {
    constexpr std::array<unsigned, 5> indices{0x2404, 0x2405, 0x6411, 0x6443, 0x6444};
    return std::find(indices.begin(), indices.end(), index) != indices.end();
}

Ao4Action exchanged(Ao4Action action, const Places& places) {
    if (action.kind == Ao4Action::write && has_outputs(action.index)) {
        action.sub = places[action.sub - 1] + 1;
    }
    if (action.kind == Ao4Action::frame && action.id == 0x300 && action.data.size() == 8) {
        const auto data = action.data;
        for (std::size_t i = 0; i < 8; ++i) {
            action.data[2 * places[i / 2] + i % 2] = data[i];
        }
    }
    return action;
}

/// Returns the frame, as text, that the device with exchanged outputs must send instead of `text`. The frame is an SDO
/// answer, or the answer to a remote frame on the identifier of RPDO2.
std::string exchanged(const std::string& text, const Places& places) {
    const unsigned id = static_cast<unsigned>(std::stoi(text.substr(0, 3), nullptr, 16));
    std::string result = text;
    if (id > 0x580 && id < 0x600) {
        const auto index = static_cast<unsigned>(std::stoi(text.substr(8, 2) + text.substr(6, 2), nullptr, 16));
        if (has_outputs(index)) {
            result[11] = static_cast<char>('1' + places[static_cast<unsigned>(text[11] - '1')]);
        }
    }
    if (id > 0x300 && id < 0x380) {
        for (std::size_t i = 0; i < 4; ++i) {
            result.replace(4 + 4 * places[i], 4, text, 4 + 4 * i, 4);
        }
    }
    return result;
}

void put_factory(cbx_ao412::FactoryData& factory, const Places& places) {
    constexpr std::array<std::int16_t, 4> offset{1, -20, 33, 0};
    constexpr std::array<std::int16_t, 4> gain{-7, 0, 250, 90};
    for (std::size_t i = 0; i < 4; ++i) {
        factory.offset[places[i]] = offset[i];
        factory.gain[places[i]] = gain[i];
    }
}

/// Performs an action on one of the two devices and returns all frames that it sends.
Frames happen(CbxBench& bench, const Ao4Action& action) {
    Frames all;
    if (action.kind == Ao4Action::power_cycle) {
        all = bench.power_on();
    } else if (action.kind == Ao4Action::terminal) {
        put_terminal(bench.inputs, action.index, action.value);
        all = bench.set_inputs();
    } else {
        all = bench.send(frame_of(action, bench.device->node_id()).text());
    }
    for (const auto& frame : bench.pass(action.wait_ms)) {
        all.push_back(frame.substr(frame.find(':') + 1));
    }
    return all;
}

void compare(const CbxBench& bench, const CbxBench& other, const Places& places) {
    const auto read = [](const CbxBench& of, int index, unsigned sub) {
        return of.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    };
    for (std::size_t i = 0; i < 4; ++i) {
        RC_ASSERT(bench.device->outputs().aout[i] == other.device->outputs().aout[places[i]]);
        for (const int index : {0x2404, 0x2405, 0x6411, 0x6443, 0x6444}) {
            const auto sub = static_cast<unsigned>(i) + 1;
            RC_ASSERT(read(bench, index, sub) == read(other, index, places[i] + 1));
        }
    }
    RC_ASSERT(bench.device->state() == other.device->state());
    RC_ASSERT(read(bench, 0x1001, 0) == read(other, 0x1001, 0));
}

}  // namespace

RC_GTEST_PROP(CbxAo412Symmetry, ExchangedOutputsGiveExchangedResults, ()) {
    verifies<req::AO4_AOUT_004, req::AO4_AOUT_005, req::AO4_AOUT_011, req::AO4_AOUT_006, req::AO4_AOUT_009,
             req::AO4_PDO_001, req::AO4_PDO_004>("property");
    Places places{0, 1, 2, 3};
    for (unsigned i = 3; i > 0; --i) {
        std::swap(places[i], places[*rc::gen::inRange(0U, i + 1U)]);
    }
    const auto steps = *rc::gen::resize(60, rc::gen::container<std::vector<Ao4Numbers>>(
                                                rc::gen::container<Ao4Numbers>(rc::gen::inRange(0U, 1000000U))));
    CbxBench bench;
    CbxBench other;
    put_factory(bench.factory, {0, 1, 2, 3});
    put_factory(other.factory, places);
    RC_ASSERT(bench.power_on() == other.power_on());
    const auto both = [&](const Ao4Action& action) {
        Frames expected;
        for (const auto& frame : happen(bench, action)) {
            expected.push_back(exchanged(frame, places));
        }
        RC_ASSERT(happen(other, exchanged(action, places)) == expected);
        compare(bench, other, places);
    };
    for (unsigned sub = 1; sub <= 4; ++sub) {
        both(ao4_write(0x6443, sub, 1, sub % 3));
        both(ao4_write(0x6444, sub, 4, 0x10005000U * sub));
        both(ao4_write(0x6411, sub, 2, 0x0777U * sub));
        both(ao4_write(0x2404, sub, 2, 40U * sub));
        both(ao4_write(0x2405, sub, 2, 777U * sub));
    }
    for (const auto& numbers : steps) {
        both(ao4_action_of(numbers));
    }
}

}  // namespace canproof::test
