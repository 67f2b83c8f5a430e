// SPDX-License-Identifier: Apache-2.0
// Compares the AX188001 with a naive model, a second and simple implementation of the whole device (manual, chapters 1
// and 3). Whatever is written, commanded, wired or heated, the device must always send the same frames and show the
// same values as the model.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "properties/devices/ax188001/naive_comparison.hpp"
#include "properties/devices/ax188001/tcs_generator.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Runs device and model side by side.
class Pair {
  public:
    Pair() {
        model_.power_on(naive_tcs::terminals_of(rig_.bench.inputs), 0);
        compare();
    }

    /// Performs an action, then lets time pass. With `leaves_last`, does not perform a reading that is due at the end
    /// of this time, so that the next action comes before it.
    void happen(const TcsAction& action, bool leaves_last = false) {
        std::ostringstream text;
        text << rig_.now_ms() << " ms: " << action << "\n";
        RC_LOG() << text.str();
        rig_.happen(action);
        const naive_tcs::Terminals at = naive_tcs::terminals_of(rig_.bench.inputs);
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
    void compare() {
        const auto expected = naive_tcs::in_order(model_.take_sent());
        const auto seen = naive_tcs::in_order(rig_.take());
        RC_ASSERT(seen == expected);
        const auto check = [](bool holds, const char* what, unsigned index) {
            if (!holds) {
                RC_FAIL(fmt::format("{} ({:04X}h)", what, index));
            }
        };
        naive_tcs::compare_values(*rig_.bench.device, model_, check);
        naive_tcs::compare_errors(*rig_.bench.device, model_, check);
        naive_tcs::compare_outputs(*rig_.bench.device, model_, check);
    }

    TcsRig rig_;
    naive_tcs::Ax188001 model_{
        [this](unsigned channel) { return naive_tcs::shown_celsius(*rig_.bench.device, channel); }};
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
