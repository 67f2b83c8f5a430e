// SPDX-License-Identifier: Apache-2.0
// A socketcand server on the loopback, at a port chosen by the kernel, as a fixture. Data of a client have arrived when
// poll() reports them, so no test waits for a clock. Virtual time passes only while the bus has work.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <memory>
#include <string>
#include <vector>

#include "host/sim/bus/socketcand_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/support/tcp_client.hpp"

namespace canproof::host::test {

class SocketcandServer : public testing::Test {
  protected:
    static constexpr int most_looks = 500;  // reached only in a broken test
    static inline const std::string join = "< open can0 >< rawmode >";
    static inline const std::string joined = "< hi >< ok >< ok >";

    SocketcandServer() {
        bus.listen([this](const BusFrame& frame) { log.push_back(format_frame(frame.frame)); });
        bus.on_notice([this](const std::string& text) { notices.push_back(text); });
        bus.attach(node);
    }
    /// Runs the bus until `done`. Returns false when this never happens.
    template <typename Condition>
    bool until(const Condition& done) {
        for (int looks = 0; looks < most_looks;) {
            bus.poll(now);
            bus.advance(now);
            if (done()) {
                return true;
            }
            const Instant due = bus.next_deadline();
            if (due <= now + soon) {
                now = now < due ? due : now;
            } else {
                looks += wait_for_the_kernel() ? 0 : 1;
            }
        }
        return false;
    }
    void pass(Duration time) {
        now = now + time;
        bus.poll(now);
        bus.advance(now);
    }
    /// Waits until data of a client have arrived. Does not read them.
    bool arrive() const {
        int looks = 0;
        while (looks < most_looks && !wait_for_the_kernel()) {
            ++looks;
        }
        return looks < most_looks;
    }
    std::vector<std::unique_ptr<canproof::test::TcpClient>> clients_that(const std::string& say, std::size_t count) {
        std::vector<std::unique_ptr<canproof::test::TcpClient>> all;
        for (std::size_t i = 0; i < count; ++i) {
            all.push_back(std::make_unique<canproof::test::TcpClient>(bus.port()));
            all.back()->say(say);
            EXPECT_TRUE(until([&] { return bus.clients() == i + 1; }));
        }
        return all;
    }

    SocketcandBus bus{{"127.0.0.1", 0}, 1000000, {}, 0};
    PlainNode node{"node"};
    Instant now{};
    std::vector<std::string> log;
    std::vector<std::string> notices;

  private:
    // A wait for the kernel ends after this time, because bytes may also be on their way to a client, whose socket is
    // not in watches().
    static constexpr int look_again_ms = 10;
    // Virtual time goes on to a deadline that is at most this far away: those of the bus are, those of its clients are
    // not.
    static constexpr Duration soon = milliseconds(500);

    bool wait_for_the_kernel() const {
        std::vector<pollfd> waiting;
        for (const Watch& watch : bus.watches()) {
            const int events = (watch.readable ? POLLIN : 0) | (watch.writable ? POLLOUT : 0);
            waiting.push_back({watch.descriptor, static_cast<short>(events), 0});
        }
        return ::poll(waiting.data(), waiting.size(), look_again_ms) > 0;
    }
};

}  // namespace canproof::host::test
