// SPDX-License-Identifier: Apache-2.0
// A fake of the kernel's CAN calls: the test sets the answers of the kernel in lists, and the fake records the calls.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "host/sim/bus/can_system.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/kernel_frame.hpp"

namespace canproof::host::test {

class FakeCanSystem : public CanSystem {
  public:
    struct Socket {
        bool error_frames{false};
        std::vector<can_filter> filters;
        struct Arrival {
            CanReception got;
            int error{0};  ///< returned instead of `got` unless 0
        };
        std::deque<Arrival> arriving;
        std::uint32_t dropped{0};
        std::deque<int> send_answers;  ///< one per call; 0 when the list is empty
        std::vector<std::string> sent;
        std::vector<std::size_t> filters_when_sent;  ///< number of filters at the time of each frame of `sent`
        int send_calls{0};
    };

    CanOpening open(const std::string&, bool error_frames) override {
        if (open_error != 0) {
            return {Descriptor{}, open_error};
        }
        const int descriptor = next_descriptor++;
        EXPECT_FALSE(is_open(descriptor)) << "the number is in use";
        EXPECT_EQ(dup2(nowhere_.number(), descriptor), descriptor);
        sockets[descriptor].error_frames = error_frames;
        return {Descriptor{descriptor}, 0, roomy && descriptor >= first_roomy};
    }
    int set_filters(int descriptor, const std::vector<can_filter>& filters) override {
        sockets[descriptor].filters = filters;
        return 0;
    }
    int send(int descriptor, const can_frame& frame) override {
        Socket& socket = sockets[descriptor];
        ++socket.send_calls;
        int answer = up ? 0 : ENETDOWN;
        if (!socket.send_answers.empty()) {
            answer = socket.send_answers.front();
            socket.send_answers.pop_front();
        }
        if (answer == 0) {
            socket.sent.push_back(format_frame(from_kernel(frame)));
            socket.filters_when_sent.push_back(socket.filters.size());
        }
        return answer;
    }
    int receive(int descriptor, std::vector<CanReception>& into) override {
        Socket& socket = sockets[descriptor];
        for (std::size_t n = 0; n < batch; ++n) {
            if (socket.arriving.empty()) {
                return n == 0 ? EAGAIN : 0;
            }
            const Socket::Arrival next = socket.arriving.front();
            if (next.error != 0 && n != 0) {
                return 0;
            }
            socket.arriving.pop_front();
            if (next.error != 0) {
                return next.error;
            }
            into.push_back(next.got);
        }
        return 0;
    }
    std::uint32_t dropped(int descriptor) override { return sockets[descriptor].dropped; }
    unsigned interface_number(const std::string&) override { return number; }
    bool is_up(const std::string&) override { return up; }
    std::uint32_t bit_rate(const std::string&) override { return rate; }
    BitRateOutcome set_bit_rate(const std::string&, std::uint32_t wanted) override {
        rates_set.push_back(wanted);
        return rate_refusal.empty() ? BitRateOutcome{true, ""} : BitRateOutcome{false, rate_refusal};
    }
    bool restart(const std::string&) override {
        ++restarts;
        return restart_answer;
    }
    std::uint64_t realtime_ns() override { return realtime_us * 1000; }

    /// Lets a frame arrive at a socket with `us` as its real-time stamp.
    void arrive(int descriptor, const std::string& text, std::uint64_t us, std::uint32_t dropped = 0) {
        CanReception one;
        one.frame = to_kernel(parse_frame(text, "test"));
        one.stamp_ns = us * 1000;
        one.dropped = dropped;
        sockets[descriptor].dropped = dropped;
        sockets[descriptor].arriving.push_back({one});
    }
    void arrive_error(int descriptor, std::uint32_t error_class, std::uint8_t controller) {
        CanReception one;
        one.frame.can_id = CAN_ERR_FLAG | error_class;
        one.frame.can_dlc = 8;
        one.frame.data[1] = controller;
        one.stamp_ns = realtime_us * 1000;
        sockets[descriptor].arriving.push_back({one});
    }
    static bool is_open(int descriptor) { return fcntl(descriptor, F_GETFD) >= 0; }
    void fail(int descriptor, int error) { sockets[descriptor].arriving.push_back({{}, error}); }

    static constexpr std::size_t batch = 2;
    std::map<int, Socket> sockets;
    int next_descriptor{100};
    int open_error{0};
    bool roomy{true};
    int first_roomy{0};  ///< sockets below this descriptor get a small buffer
    unsigned number{3};
    bool up{true};
    std::uint32_t rate{0};
    std::string rate_refusal;
    std::vector<std::uint32_t> rates_set;
    int restarts{0};
    bool restart_answer{true};
    std::uint64_t realtime_us{5000000};

  private:
    Descriptor nowhere_{::open("/dev/null", O_RDONLY | O_CLOEXEC)};  ///< each socket is a copy of it
};

}  // namespace canproof::host::test
