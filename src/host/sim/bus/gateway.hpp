// SPDX-License-Identifier: Apache-2.0
// A gateway between a simulated bus and the world outside, such as a client of socketcand. It sends the frames from
// outside in the order of arrival, and stores a limited number of them.
#pragma once

#include <deque>
#include <functional>
#include <string>

#include "host/sim/bus/bus.hpp"

namespace canproof::host {

class Gateway final : public BusNode {
  public:
    using Outlet = std::function<void(const Frame&, Instant)>;

    /// Makes a gateway. `outlet` is called with each frame that another node has sent; it may be empty.
    Gateway(std::string name, std::size_t capacity, Outlet outlet)
        : name_{std::move(name)}, capacity_{capacity}, outlet_{std::move(outlet)} {}

    /// Stores a frame to send. Returns false when the gateway is full; then the caller must try again later.
    bool put(const Frame& frame) {
        if (is_full()) {
            return false;
        }
        waiting_.push_back(frame);
        return true;
    }
    bool is_full() const { return waiting_.size() >= capacity_; }

    const std::string& name() const override { return name_; }
    const Frame* next_frame() const override { return waiting_.empty() ? nullptr : &waiting_.front(); }
    void take_frame() override { waiting_.pop_front(); }
    void receive(const Frame& frame, Instant now) override {
        if (outlet_) {
            outlet_(frame, now);
        }
    }
    void set_can_state(CanState, Instant) override {}
    void set_overrun(bool, Instant) override {}
    const std::vector<AcceptanceFilter>& filters() const override { return accept_everything(); }
    std::uint32_t bit_rate() const override { return 0; }

  private:
    std::string name_;
    std::size_t capacity_;
    Outlet outlet_;
    std::deque<Frame> waiting_;
};

}  // namespace canproof::host
