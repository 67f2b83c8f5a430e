// SPDX-License-Identifier: Apache-2.0
// Checks that the channels of the AX188001 are equal and independent (manual, 1.1 and appendix A). If the parameters
// and terminals of the two channels are exchanged, their frames and values must be exchanged, and nothing else may
// change.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "properties/devices/ax188001/tcs_generator.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

bool has_channels(int index) {
    constexpr std::array<int, 9> indices{0x2000, 0x4000, 0x4010, 0x4020, 0x4030, 0x6110, 0x6112, 0x6126, 0x6127};
    return std::find(indices.begin(), indices.end(), index) != indices.end();
}

TcsAction exchanged(TcsAction action) {
    action.channel = 3 - action.channel;
    if (action.kind == TcsAction::write && has_channels(action.index)) {
        action.sub = 3 - action.sub;
    }
    return action;
}

/// Returns `text` with two adjacent parts exchanged: `length` characters at `from`, and the `length` characters behind
/// them.
std::string turned(const std::string& text, std::size_t from, std::size_t length) {
    return text.substr(0, from) + text.substr(from + length, length) + text.substr(from, length) +
           text.substr(from + 2 * length);
}

/// Returns the frame that the device with exchanged channels must send instead of `frame`. Exchanges byte 3 in
/// emergency messages of a channel, the halves of TPDO1 and TPDO3, the first two bytes of TPDO4, and the sub-index of
/// an SDO answer.
std::string exchanged(const std::string& frame) {
    const std::string id = frame.substr(0, 3);
    if (id == "0FF" && (frame.substr(4, 4) == "01F0" || frame.substr(4, 4) == "11F0")) {
        return frame.substr(0, 10) + (frame.substr(10, 2) == "01" ? "02" : "01") + frame.substr(12);
    }
    if (id == "1FF") {
        return turned(frame, 4, 4);
    }
    if (id == "3FF") {
        return turned(frame, 4, 8);
    }
    if (id == "4FF") {
        return turned(frame, 4, 2);
    }
    const bool is_answer = id == "5FF";
    if (is_answer && has_channels(std::stoi(frame.substr(8, 2) + frame.substr(6, 2), nullptr, 16))) {
        return frame.substr(0, 10) + (frame.substr(10, 2) == "01" ? "02" : "01") + frame.substr(12);
    }
    return frame;
}

/// Sorts the frames of each moment as text, so that the order of the channels does not matter. Replaces the error
/// register in emergency messages by dots, because it depends on the order of the messages.
TimedFrames sorted(TimedFrames frames) {
    for (auto& [ms, frame] : frames) {
        frame = frame.rfind("0FF#", 0) == 0 ? frame.replace(8, 2, "..") : frame;
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

void compare(const TcsRig& rig, const TcsRig& other) {
    const auto read = [](const TcsRig& of, int index, int sub) {
        return of.bench.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    };
    for (int channel = 1; channel <= 2; ++channel) {
        for (const int index : {0x2010, 0x6100, 0x6150, 0x7130}) {
            RC_ASSERT(read(rig, index, channel) == read(other, index, 3 - channel));
        }
        const auto at = static_cast<std::size_t>(channel - 1);
        RC_ASSERT(rig.bench.device->outputs().tc_gain[at] == other.bench.device->outputs().tc_gain[1 - at]);
    }
    for (const int index : {0x1001, 0x2100, 0x2130, 0x3100, 0x3130}) {
        RC_ASSERT(read(rig, index, 0) == read(other, index, 0));
    }
    RC_ASSERT(rig.bench.device->state() == other.bench.device->state());
}

/// Returns the entries of 1003h (error list). If `is_exchanged` is true, exchanges the channels in errors of a channel.
std::vector<std::uint32_t> listed(const TcsRig& rig, bool is_exchanged) {
    std::vector<std::uint32_t> all;
    const auto& objects = rig.bench.device->objects();
    for (std::uint8_t sub = 1; sub <= objects.read(0x1003, 0); ++sub) {
        const std::uint32_t entry = objects.read(0x1003, sub);
        const bool is_channels = (entry & 0xFFFFU) == 0xF001 || (entry & 0xFFFFU) == 0xF011;
        all.push_back(is_channels && is_exchanged ? entry ^ 0x00030000U : entry);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

RC_GTEST_PROP(Ax188001Symmetry, ExchangedChannelsGiveExchangedResults, ()) {
    verifies<req::TCS_IN_011, req::TCS_LIM_001, req::TCS_LIM_003, req::TCS_LIM_012, req::TCS_VAL_001, req::TCS_ERR_001,
             req::TCS_PDO_001>("property");
    auto setup = setup_of(*rc::gen::container<std::vector<unsigned>>(50, rc::gen::inRange(0U, 1000000U)));
    setup.reaction[1] =
        1;  // otherwise the order of the channels would decide which of two simultaneous faults stops the node first
    const auto steps = *rc::gen::resize(
        50,
        rc::gen::container<TcsNumbers>(rc::gen::container<std::array<unsigned, 4>>(rc::gen::inRange(0U, 1000000U))));
    TcsRig rig;
    TcsRig other;
    // 1003h lists nine errors; a tenth error removes the oldest. If errors began at the same time, the order of the
    // channels decides which one is removed. So a full list is not compared.
    bool is_full = false;
    const auto happen = [&](const TcsAction& action) {
        play(rig, action);
        play(other, exchanged(action));
        TimedFrames expected;
        for (const auto& [ms, frame] : rig.take()) {
            expected.emplace_back(ms, exchanged(frame));
        }
        RC_ASSERT(sorted(other.take()) == sorted(expected));
        compare(rig, other);
        is_full = is_full || rig.bench.device->objects().read(0x1003, 0) == 9;
        RC_ASSERT(is_full || listed(rig, true) == listed(other, false));
    };
    for (const TcsAction& action : writes_of(setup)) {
        happen(action);
    }
    for (const TcsAction& action : communication_of(setup)) {
        happen(action);
    }
    for (const TcsAction& action : start_of(setup)) {
        happen(action);
    }
    for (const auto& numbers : steps) {
        const TcsAction action = action_of(setup, numbers);
        if (action.index != 0x1029) {
            happen(action);
        }
    }
}

}  // namespace canproof::test
