// SPDX-License-Identifier: Apache-2.0
// Compares NMT, heartbeat and guarding with those of a naive node (a second, simple implementation), for any frames at
// any times (CiA 301, 7.2.8, 7.3.2).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include "generated/canopen/requirements.hpp"
#include "properties/support/logged_slave.hpp"
#include "properties/support/naive_error_control.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace naive = naive_error_control;

class Happens : public rc::state::Command<naive::Node, LoggedSlave> {
  public:
    explicit Happens(const naive::Event& event) : event_{event} {}

    void apply(naive::Node& node) const override {
        naive::apply(node, event_);
        node.take_said();
    }
    void run(const naive::Node& before, LoggedSlave& slave) const override {
        naive::Node node = before;
        naive::apply(node, event_);
        slave.heard.clear();
        if (event_.kind == 8) {
            slave.play_pause(naive::pause_of(event_));
        } else {
            slave.play(text());
        }
        naive::Said said;
        for (const auto& [ms, frame] : slave.heard) {
            if (frame.rfind("705#", 0) == 0) {
                said.emplace_back(ms, std::stoul(frame.substr(4), nullptr, 16));
            }
        }
        slave.demand(said == node.take_said(), "what is said on 705h");
        slave.demand(static_cast<unsigned>(slave.device->node().state()) == node.state(), "the state");
    }
    void show(std::ostream& out) const override {
        if (event_.kind == 8) {
            out << "pause of " << naive::pause_of(event_) << " ms";
        } else {
            out << "can0 " << text();
        }
    }

  private:
    std::string text() const {
        const naive::EventFrame frame = naive::frame_of(event_);
        return frame_text(frame.id, frame.data, frame.remote);
    }
    naive::Event event_;
};

}  // namespace

RC_GTEST_PROP(ErrorControlLaw, HeartbeatAndGuardingMatchTheNaiveModel, ()) {
    verifies<req::CO_NMT_001, req::CO_NMT_002, req::CO_NMT_003, req::CO_NMT_009, req::CO_HB_001, req::CO_HB_002,
             req::CO_HB_004, req::CO_HB_003, req::CO_GUARD_001, req::CO_GUARD_002, req::CO_GUARD_007, req::CO_GUARD_003,
             req::CO_GUARD_008>("property");
    LoggedSlave slave;
    naive::Node node;
    node.take_said();
    rc::state::check(node, slave, [](const naive::Node&) {
        const auto event = rc::gen::build<naive::Event>(
            rc::gen::set(&naive::Event::kind,
                         rc::gen::weightedElement<unsigned>(
                             {{3, 0U}, {2, 1U}, {2, 2U}, {2, 3U}, {3, 4U}, {1, 5U}, {4, 6U}, {4, 7U}, {8, 8U}})),
            rc::gen::set(&naive::Event::a, number_up_to(255)), rc::gen::set(&naive::Event::b, number_up_to(700)));
        return rc::gen::map(event, [](const naive::Event& one) -> std::shared_ptr<const Happens::CommandType> {
            return std::make_shared<const Happens>(one);
        });
    });
}

}  // namespace canproof::test
