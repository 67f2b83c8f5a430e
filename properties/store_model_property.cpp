// SPDX-License-Identifier: Apache-2.0
// Compares the storing of parameters with a model that has the present and the saved values. The power fails at any
// byte that a save or restore writes (CiA 301, 7.5.2.13, 7.5.2.14).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <fmt/format.h>
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include <array>
#include <optional>

#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/sdo_text.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

// One value of each parameter group: 1017h (producer heartbeat time), 6411h:1 (output value) and 2404h:1 (offset).
constexpr std::size_t group_count = 3;
const std::array<std::string, group_count> objects{"171000", "116401", "042401"};

struct Model {
    std::array<unsigned, group_count> now{};
    std::array<std::optional<unsigned>, group_count> saved{};
};

/// The device under test, and the number of bytes that a save must write until it is committed.
class Sut : public CbxBench {
  public:
    Sut() {
        CbxBench spare;
        spare.power_on();
        spare.send("603#2310100173617665");
        save_size = spare.memory.written() - 1;  // the last byte of a save only invalidates the old set
        power_on();
    }
    std::size_t save_size{0};
};

struct Event {
    /// 0 to 2: write of a value; 3: save (1010h); 4: restore (1011h); 5: power cycle; 6: reset node; 7: reset
    /// communication; 8: save or restore with a wrong signature.
    unsigned kind{0};
    unsigned group{0};     ///< for a write, the group of the value (0 to 2); for a save or restore, the sub-index minus
                           ///< one
    unsigned value{0};     ///< value of a write
    unsigned permille{0};  ///< after how many thousandths of the bytes of a save or restore the power fails; from 1000
                           ///< on: no failure
};

class Happens : public rc::state::Command<Model, Sut> {
  public:
    explicit Happens(const Event& event) : event_{event} {}

    void apply(Model& model) const override {
        const unsigned groups = event_.group % 4 == 0 ? 7U : 1U << (event_.group % 4 - 1U);
        for (std::size_t i = 0; i < group_count; ++i) {
            const bool meant = ((groups >> i) & 1U) != 0;
            if (event_.kind < 3 && i == event_.group % group_count) {
                model.now[i] = event_.value;
            } else if (event_.kind == 3 && meant && !is_cut()) {
                model.saved[i] = model.now[i];
            } else if (event_.kind == 4 && meant && !is_cut()) {
                model.saved[i].reset();
            }
        }
        const bool starts = event_.kind == 5 || event_.kind == 6 || (event_.kind < 5 && event_.kind > 2 && is_cut());
        for (std::size_t i = 0; i < group_count; ++i) {
            if (starts || (event_.kind == 7 && i == 0)) {
                model.now[i] = model.saved[i].value_or(0);
            }
        }
    }
    void run(const Model& before, Sut& device) const override {
        if (event_.kind == 3 || event_.kind == 4) {
            save(device);
        } else if (event_.kind == 5) {
            device.power_on();
        } else {
            device.send(text());
        }
        const Model model = nextState(before);
        for (std::size_t i = 0; i < group_count; ++i) {
            RC_ASSERT(device.send("603#40" + objects[i] + "00000000").at(0).substr(12, 4) == hex_le(model.now[i], 2));
        }
    }
    void show(std::ostream& out) const override {
        out << (event_.kind == 5 ? "power cycle" : "can0 " + text());
        if (event_.kind > 2 && event_.kind < 5 && is_cut()) {
            out << " with power failing at " << event_.permille << " permille";
        }
    }

  private:
    bool is_cut() const { return event_.permille < 1000; }
    std::string text() const {
        switch (event_.kind) {
            case 3:
            case 4:
                return fmt::format("603#23{}10{:02X}{}", event_.kind == 3 ? "10" : "11", event_.group % 4 + 1,
                                   event_.kind == 3 ? "73617665" : "6C6F6164");
            case 8:
                return fmt::format("603#23{}10{:02X}{}", event_.value % 2 == 0 ? "10" : "11", event_.group % 4 + 1,
                                   event_.value % 2 == 0 ? "73617664" : "73617665");
            case 6:
                return "000#8103";
            case 7:
                return "000#8203";
            default:
                return "603#2B" + objects[event_.group % group_count] + hex_le(event_.value, 2) + "0000";
        }
    }
    void save(Sut& device) const {
        if (is_cut()) {
            device.memory.cut_power_after(device.save_size * event_.permille / 1000);
        }
        device.send(text());
        if (is_cut()) {
            device.memory.restore_power();
            device.power_on();
        }
    }
    Event event_;
};

}  // namespace

RC_GTEST_PROP(StoreLaw, StoredContentMatchesTheNaiveModelAfterSavesRestoresAndPowerCuts, ()) {
    verifies<req::CO_STORE_001, req::CO_STORE_011, req::CO_STORE_002, req::CO_STORE_003, req::CO_STORE_012,
             req::CO_STORE_004, req::CO_STORE_005, req::CO_STORE_013>("property");
    Sut device;
    rc::state::check(Model{}, device, [](const Model&) {
        const auto event = rc::gen::build<Event>(
            rc::gen::set(&Event::kind, rc::gen::weightedElement<unsigned>(
                                           {{4, 0U}, {4, 3U}, {2, 4U}, {2, 5U}, {1, 6U}, {1, 7U}, {1, 8U}})),
            rc::gen::set(&Event::group, rc::gen::inRange(0U, 12U)),
            rc::gen::set(&Event::value, rc::gen::element(0U, 1U, 1000U, 30000U, 32767U)),
            rc::gen::set(&Event::permille,
                         rc::gen::weightedOneOf<unsigned>({{3, rc::gen::just(1000U)},
                                                           {2, rc::gen::inRange(0U, 1000U)},
                                                           {1, rc::gen::element(0U, 1U, 998U, 999U)}})));
        return rc::gen::map(event, [](const Event& one) -> std::shared_ptr<const Happens::CommandType> {
            return std::make_shared<const Happens>(one);
        });
    });
}

}  // namespace canproof::test
