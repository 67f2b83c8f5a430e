// SPDX-License-Identifier: Apache-2.0
// Compares the CAN-CBX-AO412 with a naive model, a second and simple implementation of the whole device (manual,
// chapters 3 and 7). Whatever is written, received or switched, and whatever fails, the device must always send the
// same frames and show the same values as the model.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/cbx_ao412/requirements.hpp"
#include "properties/devices/cbx-ao412/ao4_scenario.hpp"
#include "properties/devices/cbx-ao412/naive_comparison.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using TimedFrames = std::vector<std::pair<std::uint64_t, std::string>>;

/// Runs device and model side by side.
class Pair {
  public:
    Pair() {
        bench_.factory.offset = {1, -20, 33, 0};
        bench_.factory.gain = {-7, 0, 250, 90};
        seen_.clear();
        note(bench_.power_on());
        model_.power_on(naive_ao4::terminals_of(bench_.inputs), 0);
        compare();
    }

    void happen(const Ao4Action& action) {
        RC_LOG() << now_ms() << " ms: " << action << "\n";
        if (action.kind == Ao4Action::power_cycle) {
            note(bench_.power_on());
            model_.power_on(naive_ao4::terminals_of(bench_.inputs), now_ms());
        } else if (action.kind == Ao4Action::terminal) {
            put_terminal(bench_.inputs, action.index, action.value);
            note(bench_.set_inputs());
            model_.set_terminals(naive_ao4::terminals_of(bench_.inputs));
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
        if (bench_.device->next_deadline() <= bench_.now) {  // the device is called only when its deadline has come
            bench_.device->advance(bench_.now);
            note(bench_.sent());
            RC_ASSERT(bench_.device->next_deadline() > bench_.now);  // no work that is due is left
        }
        model_.pass(now_ms() - model_.now());
    }
    void compare() {
        const TimedFrames seen = std::exchange(seen_, {});
        RC_ASSERT(seen == model_.take_sent());
        const auto check = [](bool holds, const char* what) {
            if (!holds) {
                RC_FAIL(what);
            }
        };
        naive_ao4::compare_outputs(*bench_.device, model_, check);
        if (model_.runs()) {
            naive_ao4::compare_objects(*bench_.device, model_, check);
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
    for (unsigned sub = 1; sub <= 4; ++sub) {  // gives the four outputs different parameters and values at the start
        pair.happen(ao4_write(0x6443, sub, 1, sub % 3));
        pair.happen(ao4_write(0x6444, sub, 4, 0x10005000U * sub));
        pair.happen(ao4_write(0x6411, sub, 2, 0x0777U * sub));
    }
    pair.happen(ao4_write(0x1016, 1, 4, 0x310000U | *rc::gen::inRange(30U, 500U)));
    if (*rc::gen::arbitrary<bool>()) {  // in half of the cases, the device starts itself after each boot-up
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
