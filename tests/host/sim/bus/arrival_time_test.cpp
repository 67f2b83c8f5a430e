// SPDX-License-Identifier: Apache-2.0
// A frame has the time of its arrival, also when the process is suspended before or after it reads its clock.
#include <gtest/gtest.h>
#include <poll.h>

#include <memory>

#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/socketcand_bus.hpp"
#include "host/sim/bus/socketcand_client_bus.hpp"
#include "host/sim/bus/stamped_read.hpp"
#include "tests/host/sim/bus/scripted_server.hpp"
#include "tests/host/sim/bus/socketcan_case.hpp"
#include "tests/support/tcp_client.hpp"

namespace canproof::host::test {

namespace {

constexpr int longest_wait_ms = 5000;  // reached only when the expected data never arrive
// number of comparisons of the run's clock with the real time, of which one is exact
constexpr int comparisons = 100;

/// A socket that sends to itself until the kernel stamps what arrives. The kernel begins to stamp some time after the
/// first socket asks for it; before that, the stamp is the time of reading. The kernel continues as long as this socket
/// exists.
class StampedSocket {
  public:
    StampedSocket() {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), size), 0);
        EXPECT_EQ(getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size), 0);
        EXPECT_EQ(connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), size), 0);
        ask_for_stamps(descriptor_);
        char byte = 0;
        for (std::uint64_t stamp = UINT64_MAX, arrived = 0; stamp > arrived;) {
            EXPECT_EQ(send(descriptor_, &byte, 1, 0), 1);
            arrived = kernel_realtime_ns();
            while (kernel_realtime_ns() == arrived) {
            }
            stamp = receive_stamped(descriptor_, &byte, 1).stamp_ns;
        }
    }
    ~StampedSocket() { close(descriptor_); }
    StampedSocket(const StampedSocket&) = delete;
    StampedSocket& operator=(const StampedSocket&) = delete;

  private:
    int descriptor_{socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
};

/// A bus over real TCP and a run whose clock is the real time. Its process is late before and after it reads data.
class LateRun : public testing::Test {
  protected:
    void start(std::unique_ptr<Bus> made) {
        bus = std::move(made);
        bus->use_clock([this] { return clock(); });
        bus->listen([this](const BusFrame& frame) { frames.push_back(frame); });
        for (int i = 0; i < comparisons; ++i) {
            turn();
        }
    }
    Instant clock() const { return Instant{(kernel_realtime_ns() - begin_ns_) / 1000U}; }
    /// Waits 2 ms, longer than the error of a comparison of two clocks. Returns the time of the run.
    Instant later() const {
        const Instant from = clock() + milliseconds(2);
        while (clock() <= from) {
        }
        return clock();
    }
    /// Waits until data have arrived. Does not read them.
    void wait_for_data() const {
        std::vector<pollfd> waiting;
        for (const Watch& watch : bus->watches()) {
            waiting.push_back({watch.descriptor, static_cast<short>(watch.readable ? POLLIN : POLLOUT), 0});
        }
        ASSERT_GT(::poll(waiting.data(), waiting.size(), longest_wait_ms), 0);
    }
    void turn() {
        const Instant now = clock();
        bus->advance(earliest(bus->poll(now), now));
    }
    /// Calls `send` to send a frame after the run has read its clock, and lets the run read the frame late. Returns the
    /// frame; sets `first` and `last` to the times between which it arrived.
    template <typename Send>
    BusFrame read_late(const Send& send, Instant& first, Instant& last) {
        const Instant early = clock();
        first = later();
        send();
        wait_for_data();
        last = clock();
        later();
        bus->poll(early);
        for (const Instant end = later(); frames.empty() && bus->next_deadline() <= end;) {
            bus->advance(bus->next_deadline());
        }
        EXPECT_EQ(frames.size(), 1U);
        return frames.empty() ? BusFrame{} : frames.front();
    }

    std::unique_ptr<Bus> bus;
    std::vector<BusFrame> frames;

  private:
    StampedSocket stamps_;
    std::uint64_t begin_ns_{kernel_realtime_ns() - 1000000000U};
};

/// Returns whether the time is between both, apart from the error of a comparison.
testing::AssertionResult is_between(Instant first, Instant time, Instant last) {
    const Duration error = milliseconds(1);
    if (first <= time + error && time <= last + error) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << time.us << " is not between " << first.us << " and " << last.us;
}

}  // namespace

TEST_F(LateRun, FrameOfASocketcandClientStartsWhenItArrived) {
    auto server = std::make_unique<SocketcandBus>(ListenAddress{"127.0.0.1", 0}, 1000000, BusFaultRates{}, 0);
    const std::uint16_t port = server->port();
    start(std::move(server));
    canproof::test::TcpClient client{port};
    client.say("< open can0 >< rawmode >");
    while (client.heard() != "< hi >< ok >< ok >") {
        turn();
    }
    Instant first{};
    Instant last{};
    const BusFrame got = read_late([&] { client.say("< send 123 1 AA >"); }, first, last);
    const Duration on_the_bus{frame_bits(got.frame)};  // 1 Mbit/s: a bit takes 1 us
    EXPECT_TRUE(is_between(first + on_the_bus, got.time, last + on_the_bus));
}

TEST_F(LateRun, FrameOfASocketcandServerHasItsTimeOfArrival) {
    ScriptedServer server;
    start(std::make_unique<SocketcandClientBus>(SocketcandPlace{"127.0.0.1", server.port(), "can0"}, 1000000, clock()));
    server.accept_one();
    const auto& client = static_cast<const SocketcandClientBus&>(*bus);
    for (const char* const said : {"< hi >", "< ok >", "< ok >"}) {
        turn();
        server.say(said);
        wait_for_data();
        turn();
    }
    ASSERT_TRUE(client.has_joined());
    Instant first{};
    Instant last{};
    const BusFrame got = read_late([&] { server.say("< frame 123 1.0 AA >"); }, first, last);
    EXPECT_TRUE(is_between(first, got.time, last));
}

TEST_F(SocketCan, PauseBetweenTheReadingsOfTwoClocksDoesNotMakeFramesEarlier) {
    start();
    Instant clock{1000000};  // 1 s of the run at 5 s of the real time
    bus->use_clock([&] { return clock; });
    step(0);
    // The run reads 1.001 s, then loses the processor for 114 ms. The frame arrives 100 ms after the reading.
    clock = Instant{1115000};
    system.realtime_us = 5115000;
    system.arrive(monitor, "705#05", 5101000);
    bus->poll(Instant{1001000});
    bus->advance(Instant{1115000});
    EXPECT_EQ(log, std::vector<std::string>{"1101000 - 705#05"});
}

}  // namespace canproof::host::test
