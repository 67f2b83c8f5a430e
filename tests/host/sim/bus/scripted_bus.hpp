// SPDX-License-Identifier: Apache-2.0
// Two nodes on the bus of a scripted socketcand server, as a fixture.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <memory>
#include <string>
#include <vector>

#include "host/sim/bus/socketcand_client_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/scripted_server.hpp"

namespace canproof::host::test {

class ScriptedBus : public testing::Test {
  protected:
    static constexpr int longest_wait_ms = 5000;  // reached only in a broken test

    void connect(std::uint32_t bit_rate = 125000) {
        bus =
            std::make_unique<SocketcandClientBus>(SocketcandPlace{"127.0.0.1", server.port(), "vcan0"}, bit_rate, now);
        bus->listen([this](const BusFrame& frame) {
            log.push_back(fmt::format("{} {} {}", frame.time.us, frame.sender == nullptr ? "-" : frame.sender->name(),
                                      format_frame(frame.frame)));
        });
        bus->on_notice([this](const std::string& text) { notices.push_back(text); });
        bus->attach(a);
        bus->attach(b);
        server.accept_one();
    }
    /// Waits until text of the server has arrived and reads it.
    void hear() {
        const std::vector<Watch> watches = bus->watches();
        ASSERT_EQ(watches.size(), 1U);
        pollfd waiting{watches[0].descriptor, static_cast<short>(watches[0].readable ? POLLIN : POLLOUT), 0};
        ASSERT_GT(::poll(&waiting, 1, longest_wait_ms), 0);
        bus->poll(now);
    }
    void say(const std::string& text) {
        server.say(text);
        hear();
    }
    void join(std::uint32_t bit_rate = 125000) {
        connect(bit_rate);
        hear();  // the connection is established
        say("< hi >");
        say("< ok >");
        say("< ok >");
        ASSERT_TRUE(bus->has_joined());
        bus->advance(now);
    }

    ScriptedServer server;
    Instant now{1000000};
    PlainNode a{"a"};
    PlainNode b{"b"};
    std::unique_ptr<SocketcandClientBus> bus;
    std::vector<std::string> log;
    std::vector<std::string> notices;
};

}  // namespace canproof::host::test
