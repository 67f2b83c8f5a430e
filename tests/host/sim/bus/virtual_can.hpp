// SPDX-License-Identifier: Apache-2.0
// A virtual CAN interface in this process: each frame reaches every other socket whose filters accept it.
#pragma once

#include <fcntl.h>

#include <cerrno>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/sim/bus/can_system.hpp"

namespace canproof::host::test {

class VirtualCan : public CanSystem {
  public:
    CanOpening open(const std::string&, bool) override {
        Descriptor opened{::open("/dev/null", O_RDONLY | O_CLOEXEC)};
        sockets[opened.number()] = Socket{{can_filter{0U, 0U}}, {}};
        return {std::move(opened), 0, true};
    }
    int set_filters(int descriptor, const std::vector<can_filter>& filters) override {
        sockets[descriptor].filters = filters;
        return 0;
    }
    /// Compares as the kernel does: the mask of a filter covers its format and request bits too.
    int send(int descriptor, const can_frame& frame) override {
        for (auto& [number, socket] : sockets) {
            bool wanted = false;
            for (const can_filter& one : socket.filters) {
                wanted = wanted || (frame.can_id & one.can_mask) == (one.can_id & one.can_mask);
            }
            if (number != descriptor && wanted) {
                socket.arrived.push_back({frame, realtime_us * 1000U, 0U});
            }
        }
        return 0;
    }
    int receive(int descriptor, std::vector<CanReception>& into) override {
        std::deque<CanReception>& arrived = sockets[descriptor].arrived;
        if (arrived.empty()) {
            return EAGAIN;
        }
        into.insert(into.end(), arrived.begin(), arrived.end());
        arrived.clear();
        return 0;
    }
    std::uint32_t dropped(int) override { return 0; }
    unsigned interface_number(const std::string&) override { return 1; }
    bool is_up(const std::string&) override { return true; }
    std::uint32_t bit_rate(const std::string&) override { return 0; }
    BitRateOutcome set_bit_rate(const std::string&, std::uint32_t) override { return {true, ""}; }
    bool restart(const std::string&) override { return true; }
    std::uint64_t realtime_ns() override { return realtime_us * 1000U; }

    std::uint64_t realtime_us{1000000};

  private:
    struct Socket {
        std::vector<can_filter> filters;
        std::deque<CanReception> arrived;
    };
    std::map<int, Socket> sockets;
};

}  // namespace canproof::host::test
