// SPDX-License-Identifier: Apache-2.0
// The tester as a node of a bus. It receives no frames as a node: the listener of the bus gets them.
#pragma once

#include <deque>
#include <string>

#include "host/sim/bus/bus.hpp"

namespace canproof::host::conform {

class TesterNode final : public BusNode {
  public:
    void put(const Frame& frame) { waiting_.push_back(frame); }
    std::size_t waiting() const { return waiting_.size(); }

    const std::string& name() const override { return name_; }
    const Frame* next_frame() const override { return waiting_.empty() ? nullptr : &waiting_.front(); }
    void take_frame() override { waiting_.pop_front(); }
    void receive(const Frame&, Instant) override {}
    void set_can_state(CanState, Instant) override {}
    void set_overrun(bool, Instant) override {}
    const std::vector<AcceptanceFilter>& filters() const override { return filters_; }
    std::uint32_t bit_rate() const override { return 0; }

  private:
    std::string name_{"tester"};
    std::deque<Frame> waiting_;
    std::vector<AcceptanceFilter> filters_;
};

}  // namespace canproof::host::conform
