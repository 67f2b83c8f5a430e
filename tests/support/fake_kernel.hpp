// SPDX-License-Identifier: Apache-2.0
// The state of a fake kernel with one CAN interface, vcan0, and with short writes and reads on other sockets. While an
// object is present(), the calls that fake_kernel.cpp defines use it.
#pragma once

#include <fcntl.h>
#include <linux/can.h>
#include <net/if.h>
#include <unistd.h>

#include <cstdint>
#include <ctime>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace canproof::test {

struct FakeKernel {
    struct Arrival {
        can_frame frame{};
        timespec stamp{};
        std::uint32_t dropped{0};
        bool tells_dropped{false};  ///< the kernel tells the counter only when it is not 0
    };

    FakeKernel() = default;
    FakeKernel(const FakeKernel&) = delete;
    FakeKernel& operator=(const FakeKernel&) = delete;
    ~FakeKernel() {
        for (const auto& [descriptor, peer] : peers) {
            ::close(peer);
        }
    }
    static FakeKernel*& present() {
        static FakeKernel* kernel = nullptr;
        return kernel;
    }
    static bool is_open(int descriptor) { return fcntl(descriptor, F_GETFD) >= 0; }
    bool has(int descriptor) const { return peers.count(descriptor) != 0U; }

    // the answers of the kernel
    int socket_error{0};
    int bind_error{0};
    int receive_error{0};
    std::set<int> refused;              ///< options that it does not set, of any socket
    std::map<std::string, int> errors;  ///< errno of the calls `listen` and `getsockname` when they fail
    int room{0};                        ///< size of a receive buffer
    std::uint32_t dropped{0};
    unsigned flags{IFF_UP};
    std::uint32_t rate{0};
    std::set<std::string> failing;  ///< calls of libsocketcan that fail
    std::deque<Arrival> arriving;
    std::size_t most_at_once{0};  ///< most bytes that one call sends or reads on any other socket; 0: no limit
    // the questions to it
    std::vector<int> opened;
    std::vector<int> kinds;
    std::map<int, int> peers;  ///< the other end of each socket
    std::map<int, int> bound;  ///< number of the interface of each socket
    std::vector<std::string> options;
    std::vector<can_filter> filters;
    std::string asked;
    std::vector<std::string> calls;
};

}  // namespace canproof::test
