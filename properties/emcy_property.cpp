// SPDX-License-Identifier: Apache-2.0
// Compares emergency messages, 1001h (error register) and 1003h (error list) with those of a naive node (a second,
// simple implementation), for any errors in any order (CiA 301, 7.2.7).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include "generated/canopen/requirements.hpp"
#include "properties/support/logged_slave.hpp"
#include "properties/support/naive_emcy.hpp"
#include "tests/support/device_by_sdo.hpp"
#include "tests/support/every_device.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace naive = naive_emcy;

class Occurs : public rc::state::Command<naive::Node, LoggedSlave> {
  public:
    explicit Occurs(const naive::Event& event) : event_{event} {}

    void checkPreconditions(const naive::Node& node) const override {
        RC_PRE(!node.is_blocked_for_long() || event_.kind == naive::block_kind);
    }
    void apply(naive::Node& node) const override {
        naive::apply(node, event_);
        node.take_sent();
    }
    void run(const naive::Node& before, LoggedSlave& slave) const override {
        naive::Node node = before;
        naive::apply(node, event_);
        slave.heard.clear();
        give(slave);
        std::vector<std::pair<std::uint64_t, std::string>> expected;
        for (const auto& [ms, message] : node.take_sent()) {
            expected.emplace_back(ms, frame_text(0x085, {message.begin(), message.end()}));
        }
        auto messages = slave.heard;
        messages.erase(std::remove_if(messages.begin(), messages.end(),
                                      [](const auto& one) { return one.second.rfind("085#", 0) != 0; }),
                       messages.end());
        slave.demand(messages == expected, "emergency messages");
        compare_objects(node, slave);
    }
    void show(std::ostream& out) const override {
        constexpr std::array<const char*, 5> others{"CAN state ", "overrun ", "internal fault ", "pause of ms ",
                                                    "blocked bus "};
        const naive::EventFrame frame = naive::frame_of(event_);
        if (frame.is_one) {
            out << "can0 " << frame_text(frame.id, frame.data);
        } else {
            out << others[event_.kind - 6] << event_.a;
        }
    }

  private:
    void give(LoggedSlave& slave) const {
        const naive::EventFrame frame = naive::frame_of(event_);
        Node& node = slave.device->node();
        if (frame.is_one) {
            slave.play(frame_text(frame.id, frame.data));
            return;
        }
        slave.is_blocked = event_.kind == naive::block_kind ? event_.a % 2U != 0 : slave.is_blocked;
        if (event_.kind == 6) {
            node.set_can_state(static_cast<CanState>(event_.a % 4U), slave.now);
        } else if (event_.kind == 7) {
            node.set_overrun(event_.a % 2U != 0, slave.now);
        } else if (event_.kind == 8) {
            node.set_error(ErrorId::internal_software, event_.a % 2U != 0, slave.now);
        }
        slave.hear(slave.sent());
        slave.play_pause(event_.kind == 9 ? event_.a : 0);
    }
    static void compare_objects(const naive::Node& node, const LoggedSlave& slave) {
        const ObjectDictionary& objects = std::as_const(*slave.device).objects();
        slave.demand(objects.read(0x1001, 0) == node.error_register(), "1001h");
        slave.demand(objects.read(0x1003, 0) == node.list().size(), "1003h:0");
        for (unsigned i = 0; i < node.list().size(); ++i) {
            slave.demand(objects.read(0x1003, static_cast<std::uint8_t>(i + 1)) == node.list()[i], "1003h");
        }
    }
    naive::Event event_;
};

}  // namespace

RC_GTEST_PROP(EmcyLaw, ErrorsAreReportedAsByTheNaiveModel, ()) {
    verifies<req::CO_EMCY_001, req::CO_EMCY_002, req::CO_EMCY_019, req::CO_EMCY_003, req::CO_EMCY_020, req::CO_EMCY_004,
             req::CO_EMCY_006, req::CO_EMCY_022, req::CO_EMCY_010, req::CO_EMCY_035>("property");
    LoggedSlave slave;
    rc::state::check(naive::Node{}, slave, [](const naive::Node& node) {
        const auto event = rc::gen::build<naive::Event>(
            rc::gen::set(
                &naive::Event::kind,
                rc::gen::weightedElement<unsigned>(
                    {{3, 0}, {2, 1}, {2, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}, {4, 7}, {4, 8}, {6, 9}, {2, 10}})),
            rc::gen::set(&naive::Event::a, number_up_to(60)));
        const auto next = node.is_blocked_for_long() ? rc::gen::just(naive::Event{naive::block_kind, 0U}) : event;
        return rc::gen::map(next, [](const naive::Event& one) -> std::shared_ptr<const Occurs::CommandType> {
            return std::make_shared<const Occurs>(one);
        });
    });
}

// After any events of the CAN controller, 1001h (error register) has the value that the last emergency message carried.
RC_GTEST_PROP(ErrorRegisterLaw, LastEmcyMessageOfEveryDeviceCarriesTheErrorRegister1001h, ()) {
    verifies<req::CO_EMCY_010>("property");
    const std::string name = *rc::gen::elementOf(every_device());
    DeviceBySdo unit{name, 5};
    const auto steps = *rc::gen::container<std::vector<std::pair<int, bool>>>(
        rc::gen::pair(rc::gen::inRange(0, 4), rc::gen::arbitrary<bool>()));
    unsigned told = 0;
    for (const auto& [state, overrun] : steps) {
        unit.device->set_input("can_overrun", overrun ? 1.0 : 0.0, Instant{});
        unit.device->set_input("can_state", state, Instant{});
        while (!unit.device->queue().empty()) {
            const Frame sent = unit.device->queue().pop();
            told = sent.id == 0x085 ? sent.data[2] : told;
        }
        if (state != 3) {  // in bus-off the device cannot receive an SDO request
            RC_ASSERT((unit.read(0x1001, 0) & 0xFFU) == told);
        }
    }
}

}  // namespace canproof::test
