// SPDX-License-Identifier: Apache-2.0
// Compares the AX188001 with a naive model of the whole device (manual, chapters 1 and 3). After any writes, commands,
// wiring and heating the device must send and show the same as the model, at every moment.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "properties/devices/ax188001/naive_ax188001.hpp"
#include "properties/devices/ax188001/tcs_generator.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

naive_tcs::Terminals terminals_of(const ax188001::Inputs& inputs) {
    naive_tcs::Terminals at;
    for (std::size_t i = 0; i < 2; ++i) {
        at.uv[i] = inputs.tc_microvolts[i];
        at.open[i] = inputs.tc_open[i];
        at.hum_uv[i] = inputs.tc_hum[i];
    }
    at.mains_hz = inputs.mains_frequency;
    at.cold_junction_c = inputs.cold_junction;
    at.cpu_c = inputs.cpu_temperature;
    at.supply_v = inputs.supply;
    at.overrun = inputs.can_overrun;
    at.can = inputs.can_state;
    return at;
}

/// Runs device and model side by side.
class Pair {
  public:
    Pair() {
        model_.power_on(terminals_of(rig_.bench.inputs), 0);
        compare();
    }

    /// Performs an action, then lets time pass. A reading that is due at the time of the next action may be left to
    /// that action.
    void happen(const TcsAction& action, bool leaves_last = false) {
        std::ostringstream text;
        text << rig_.now_ms() << " ms: " << action << "\n";
        RC_LOG() << text.str();
        rig_.happen(action);
        const naive_tcs::Terminals at = terminals_of(rig_.bench.inputs);
        if (action.kind == TcsAction::write) {
            model_.write(static_cast<unsigned>(action.index), static_cast<unsigned>(action.sub), action.bits);
        } else if (action.kind == TcsAction::command) {
            model_.command(static_cast<unsigned>(action.value), static_cast<unsigned>(action.sub));
        } else if (action.kind == TcsAction::power_cycle) {
            model_.power_on(at, rig_.now_ms());
        } else {
            model_.set_terminals(at);
        }
        compare();
        const Instant end = rig_.bench.now + milliseconds(action.wait_ms);
        while (rig_.bench.now < end || rig_.is_due()) {
            if (leaves_last && end <= rig_.bench.device->next_deadline()) {
                rig_.bench.now = end;
                model_.pass(rig_.now_ms() - model_.now());
                return;
            }
            rig_.go_on(end.us / 1000);
            model_.pass(rig_.now_ms() - model_.now());
            compare();
        }
    }

  private:
    std::uint32_t read(unsigned index, unsigned sub) const {
        return rig_.bench.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    }
    /// Returns the frames of one moment in the order of arbitration, also when the model sent them in two steps.
    static TimedFrames in_order(const TimedFrames& frames) {
        TimedFrames all = frames;
        for (std::size_t i = 1; i < all.size(); ++i) {
            const auto goes_before = [](const auto& a, const auto& b) {
                const bool boots = a.second == "77F#00" || b.second == "77F#00";
                return a.first == b.first && !boots && a.second.compare(0, 3, b.second, 0, 3) < 0;
            };
            for (std::size_t at = i; at > 0 && goes_before(all[at], all[at - 1]); --at) {
                std::swap(all[at], all[at - 1]);
            }
        }
        return all;
    }
    void compare() {
        const auto expected = in_order(model_.take_sent());
        const auto seen = in_order(rig_.take());
        RC_ASSERT(seen == expected);
        compare_values();
        compare_errors();
        compare_outputs();
    }
    void compare_values() const {
        for (unsigned channel = 0; channel < 2; ++channel) {
            for (const unsigned index : {0x6100U, 0x7130U, 0x6150U, 0x5040U}) {
                RC_ASSERT(std::pair(index, read(index, channel + 1)) ==
                          std::pair(index, model_.value(index, channel + 1)));
            }
            // 2010h (TC Input Microvolts) is an integer. The model gives a real number, so the two may differ by half a
            // microvolt.
            const auto shown = static_cast<double>(static_cast<std::int32_t>(read(0x2010, channel + 1)));
            RC_ASSERT(std::fabs(shown - model_.scanner().shown(channel).uv) <= 0.5 + 1e-5);
        }
        for (const unsigned index : {0x2100U, 0x2130U, 0x3100U, 0x3130U}) {
            RC_ASSERT(std::pair(index, read(index, 0)) == std::pair(index, model_.value(index, 0)));
        }
    }
    void compare_errors() const {
        RC_ASSERT(read(0x1001, 0) == model_.messages().error_register());
        const auto& list = model_.messages().list();
        RC_ASSERT(read(0x1003, 0) == list.size());
        for (unsigned sub = 1; sub <= 9; ++sub) {
            RC_ASSERT(read(0x1003, sub) == (sub <= list.size() ? list[sub - 1] : 0U));
        }
    }
    void compare_outputs() const {
        const auto& outputs = rig_.bench.device->outputs();
        RC_ASSERT(unsigned{outputs.adc_filter} == model_.application().filter_hz);
        for (std::size_t channel = 0; channel < 2; ++channel) {
            RC_ASSERT(unsigned{outputs.tc_gain[channel]} == model_.scanner().converter(channel).gain());
        }
        constexpr std::array<NmtState, 3> states{NmtState::pre_operational, NmtState::operational, NmtState::stopped};
        RC_ASSERT(rig_.bench.device->state() == states[static_cast<std::size_t>(model_.state())]);
    }

    TcsRig rig_;
    naive_tcs::Ax188001 model_{[this](unsigned channel) {
        const std::uint32_t bits = read(0x6100, channel + 1);
        float celsius = 0.0F;
        std::memcpy(&celsius, &bits, sizeof celsius);
        return celsius;
    }};
};

}  // namespace

RC_GTEST_PROP(Ax188001Model, DeviceAgreesWithTheNaiveModelOfTheManual, ()) {
    verifies<req::TCS_IN_001, req::TCS_IN_015, req::TCS_IN_002, req::TCS_IN_003, req::TCS_IN_004, req::TCS_IN_016,
             req::TCS_IN_006, req::TCS_IN_009, req::TCS_IN_011, req::TCS_LIM_001, req::TCS_LIM_002, req::TCS_LIM_003,
             req::TCS_LIM_012, req::TCS_LIM_004, req::TCS_LIM_005, req::TCS_LIM_006, req::TCS_LIM_013, req::TCS_LIM_007,
             req::TCS_LIM_009, req::TCS_LIM_010, req::TCS_LIM_014, req::TCS_LIM_016, req::TCS_LIM_017, req::TCS_LIM_018,
             req::TCS_LIM_019>("property");
    verifies<req::TCS_VAL_001, req::TCS_VAL_005, req::TCS_VAL_006, req::TCS_AVG_001, req::TCS_AVG_005, req::TCS_AVG_004,
             req::TCS_AVG_006, req::TCS_AVG_007, req::TCS_CJ_002, req::TCS_CJ_004, req::TCS_CJ_003, req::TCS_CJ_005,
             req::TCS_FD_002, req::TCS_FD_008, req::TCS_FD_009, req::TCS_FD_003, req::TCS_FD_010, req::TCS_FD_011,
             req::TCS_FD_012, req::TCS_FD_004, req::TCS_FD_005, req::TCS_FD_013, req::TCS_FD_014, req::TCS_FD_015,
             req::TCS_ERR_001, req::TCS_ERR_003, req::TCS_ERR_014, req::TCS_ERR_015, req::TCS_ERR_016, req::TCS_ERR_010,
             req::TCS_START_003, req::TCS_START_006, req::TCS_START_007, req::TCS_PDO_001>("property");
    const auto setup = setup_of(*rc::gen::container<std::vector<unsigned>>(50, rc::gen::inRange(0U, 1000000U)));
    const auto steps = *rc::gen::resize(
        50,
        rc::gen::container<TcsNumbers>(rc::gen::container<std::array<unsigned, 4>>(rc::gen::inRange(0U, 1000000U))));
    Pair pair;
    for (const TcsAction& action : writes_of(setup)) {
        pair.happen(action);
    }
    for (const TcsAction& action : communication_of(setup)) {
        pair.happen(action);
    }
    for (const TcsAction& action : start_of(setup)) {
        pair.happen(action);
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const TcsAction next = i + 1 < steps.size() ? action_of(setup, steps[i + 1]) : TcsAction{};
        const bool goes_on = next.kind != TcsAction::command && next.kind != TcsAction::power_cycle;
        pair.happen(action_of(setup, steps[i]), goes_on && i + 1 < steps.size() && steps[i][3] % 3 == 0);
    }
}

}  // namespace canproof::test
