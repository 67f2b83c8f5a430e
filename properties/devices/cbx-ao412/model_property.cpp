// SPDX-License-Identifier: Apache-2.0
// Compares the CAN-CBX-AO412 with a naive model of the whole device (manual, chapters 3 and 7). After any writes,
// frames, switching and failures the device must send and show the same as the model, at every moment.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/cbx_ao412/requirements.hpp"
#include "properties/devices/cbx-ao412/ao4_scenario.hpp"
#include "properties/devices/cbx-ao412/naive_cbx_ao412.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using TimedFrames = std::vector<std::pair<std::uint64_t, std::string>>;

naive_ao4::Terminals terminals_of(const cbx_ao412::Inputs& inputs) {
    return {inputs.switch_high, inputs.switch_low,     inputs.switch_baud,   inputs.can_state,
            inputs.can_overrun, inputs.internal_fault, inputs.hardware_fault};
}

/// Runs device and model side by side.
class Pair {
  public:
    Pair() {
        bench_.factory.offset = {1, -20, 33, 0};
        bench_.factory.gain = {-7, 0, 250, 90};
        seen_.clear();
        note(bench_.power_on());
        model_.power_on(terminals_of(bench_.inputs), 0);
        compare();
    }

    void happen(const Ao4Action& action) {
        RC_LOG() << now_ms() << " ms: " << action << "\n";
        if (action.kind == Ao4Action::power_cycle) {
            note(bench_.power_on());
            model_.power_on(terminals_of(bench_.inputs), now_ms());
        } else if (action.kind == Ao4Action::terminal) {
            put_terminal(bench_.inputs, action.index, action.value);
            note(bench_.set_inputs());
            model_.set_terminals(terminals_of(bench_.inputs));
        } else {
            exchange(frame_of(action, bench_.device->node_id()));
        }
        compare();
        const Instant end = bench_.now + milliseconds(action.wait_ms);
        while (bench_.now < end || bench_.device->next_deadline() <= bench_.now) {
            go_on(end);
            compare();
        }
    }

  private:
    std::uint64_t now_ms() const { return bench_.now.us / 1000; }
    void note(const Frames& frames) {
        for (const auto& frame : frames) {
            seen_.emplace_back(now_ms(), frame);
        }
    }
    void exchange(const Ao4Frame& frame) {
        note(bench_.send(frame.text()));
        if (frame.remote) {
            model_.ask(frame.id);
        } else {
            model_.receive(frame.id, frame.data);
        }
    }
    void go_on(Instant end) {
        const Instant next = earliest(bench_.device->next_deadline(), end);
        bench_.now = next < bench_.now ? bench_.now : next;
        if (bench_.device->next_deadline() <= bench_.now) {  // nothing is done before its deadline
            bench_.device->advance(bench_.now);
            note(bench_.sent());
            RC_ASSERT(bench_.device->next_deadline() > bench_.now);  // no work that is due is left
        }
        model_.pass(now_ms() - model_.now());
    }
    void compare() {
        const TimedFrames seen = std::exchange(seen_, {});
        RC_ASSERT(seen == model_.take_sent());
        compare_outputs();
        if (model_.runs()) {
            compare_objects();
        }
    }
    void compare_outputs() const {
        const auto& outputs = bench_.device->outputs();
        constexpr double step_v = 4.096 * 30.9 / 12.4 / 4096.0;
        for (std::size_t i = 0; i < 4; ++i) {
            const int step = static_cast<int>(std::lround(static_cast<double>(outputs.aout[i]) / step_v));
            const naive_ao4::Steps expected = model_.output(i);
            RC_ASSERT(step >= expected.low);
            RC_ASSERT(step <= expected.high);
            RC_ASSERT(std::fabs(static_cast<double>(outputs.aout[i]) - step * step_v) < 1e-5);
        }
        const std::array<bool, 4> leds{outputs.led_e, outputs.led_s, outputs.led_m, outputs.led_p};
        RC_ASSERT(leds == model_.leds());
        RC_ASSERT(bench_.device->bit_rate() == model_.rate());
        constexpr std::array<NmtState, 4> states{NmtState::initialising, NmtState::pre_operational,
                                                 NmtState::operational, NmtState::stopped};
        RC_ASSERT(bench_.device->state() == states[static_cast<std::size_t>(model_.state())]);
    }
    void compare_objects() const {
        const auto read = [&](unsigned index, unsigned sub) {
            return bench_.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
        };
        RC_ASSERT(unsigned{bench_.device->node_id()} == model_.node());
        RC_ASSERT(read(0x1001, 0) == model_.error_register());
        RC_ASSERT(read(0x1003, 0) == model_.list().size());
        for (unsigned sub = 1; sub <= 10; ++sub) {
            RC_ASSERT(read(0x1003, sub) == (sub <= model_.list().size() ? model_.list()[sub - 1] : 0U));
        }
        for (unsigned sub = 1; sub <= 4; ++sub) {
            const auto& set = model_.settings().outputs[sub - 1];
            const std::array<int, 5> expected{set.command, static_cast<int>(set.error_mode), set.error_value,
                                              set.offset, set.gain};
            const auto word = [](std::uint32_t bits) { return int{static_cast<std::int16_t>(bits)}; };
            const std::array<int, 5> shown{word(read(0x6411, sub)), static_cast<int>(read(0x6443, sub)),
                                           static_cast<int>(read(0x6444, sub)), word(read(0x2404, sub)),
                                           word(read(0x2405, sub))};
            RC_ASSERT(shown == expected);
        }
    }

    CbxBench bench_;
    TimedFrames seen_;
    naive_ao4::Device model_{{1, -20, 33, 0}, {-7, 0, 250, 90}};
};

}  // namespace

RC_GTEST_PROP(CbxAo412Model, DeviceAgreesWithTheNaiveModelOfTheManual, ()) {
    verifies<req::AO4_AOUT_004, req::AO4_AOUT_005, req::AO4_AOUT_011, req::AO4_AOUT_006, req::AO4_AOUT_007,
             req::AO4_AOUT_008, req::AO4_AOUT_009, req::AO4_AOUT_012, req::AO4_AOUT_010, req::AO4_AOUT_013,
             req::AO4_ERR_001, req::AO4_ERR_002, req::AO4_ERR_013, req::AO4_ERR_014, req::AO4_ERR_003, req::AO4_ERR_015,
             req::AO4_ERR_006, req::AO4_ERR_017, req::AO4_ERR_007, req::AO4_ERR_008, req::AO4_ERR_010, req::AO4_ERR_018,
             req::AO4_ERR_011, req::AO4_ERR_019, req::AO4_ERR_012, req::AO4_ERR_020, req::AO4_ERR_021,
             req::AO4_ERR_022>("property");
    verifies<req::AO4_LED_001, req::AO4_LED_002, req::AO4_LED_003, req::AO4_LED_007, req::AO4_LED_004, req::AO4_LED_006,
             req::AO4_START_001, req::AO4_START_003, req::AO4_START_006, req::AO4_START_004, req::AO4_GUARD_003,
             req::AO4_PDO_001, req::AO4_PDO_004, req::AO4_SW_001, req::AO4_SW_004, req::AO4_SW_002, req::AO4_STORE_001>(
        "property");
    const auto steps = *rc::gen::resize(80, rc::gen::container<std::vector<Ao4Numbers>>(
                                                rc::gen::container<Ao4Numbers>(rc::gen::inRange(0U, 1000000U))));
    Pair pair;
    for (unsigned sub = 1; sub <= 4; ++sub) {  // starts with four different outputs
        pair.happen(ao4_write(0x6443, sub, 1, sub % 3));
        pair.happen(ao4_write(0x6444, sub, 4, 0x10005000U * sub));
        pair.happen(ao4_write(0x6411, sub, 2, 0x0777U * sub));
    }
    pair.happen(ao4_write(0x1016, 1, 4, 0x310000U | *rc::gen::inRange(30U, 500U)));
    if (*rc::gen::arbitrary<bool>()) {  // the device starts itself after each boot-up
        pair.happen(ao4_write(0x1F80, 0, 4, 8));
        pair.happen(ao4_write(0x1F91, 1, 2, *rc::gen::inRange(1U, 300U)));
        pair.happen(ao4_write(0x1010, 1, 4, 0x65766173));
        pair.happen(ao4_frame(0, false, {0x81, 0}));
    }
    for (const auto& numbers : steps) {
        pair.happen(ao4_action_of(numbers));
    }
}

}  // namespace canproof::test
