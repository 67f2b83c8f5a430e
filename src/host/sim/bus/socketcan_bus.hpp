// SPDX-License-Identifier: Apache-2.0
// A bus on a SocketCAN interface. Each node has its own raw socket with kernel filters. One further socket receives
// every frame.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "host/sim/bus/bus.hpp"
#include "host/sim/bus/bus_load.hpp"
#include "host/sim/bus/can_system.hpp"
#include "host/sim/bus/echo_matcher.hpp"

namespace canproof::host {

/// Whether the run may change the state of the interface, which other programs also use.
enum class InterfaceControl {
    none,    ///< the run only reports what should be done
    granted  ///< the run sets the bit rate that LSS requests, and restarts the controller after bus-off
};

/// A bus of the kernel. A frame gets the time of its kernel time stamp. While the interface is down, the nodes are
/// bus-off: they cannot send, and their waiting frames are discarded as out of date. When the device queue is full
/// (ENOBUFS), the bus keeps the frame and tries again.
class SocketCanBus final : public Bus {
  public:
    /// First pause after ENOBUFS. Each further pause is twice as long, up to `longest_pause`.
    static constexpr Duration first_pause = milliseconds(1);
    static constexpr Duration longest_pause = milliseconds(16);
    /// Time between two searches for an interface that is down or does not exist any more.
    static constexpr Duration search_period = milliseconds(100);
    /// Time after which the run restarts a controller that is still bus-off.
    static constexpr Duration restart_after = milliseconds(500);
    /// Approximate number of frames that the bus keeps when the run is behind real time. Further frames stay in the
    /// kernel.
    static constexpr std::size_t most_arrived = 65536;

    /// Opens the bus at the time `now`. Throws InputError when the interface cannot be opened.
    SocketCanBus(std::string interface, CanSystem& system, InterfaceControl control, Instant now);
    SocketCanBus(const SocketCanBus&) = delete;
    SocketCanBus& operator=(const SocketCanBus&) = delete;

    void attach(BusNode& node) override;
    bool put(const Frame& frame, Instant now) override;
    std::vector<Watch> watches() const override;
    Instant poll(Instant now) override;
    void advance(Instant now) override;
    Instant next_deadline() const override;
    BusReport report(Instant now) const override;
    const std::string& interface() const override { return interface_; }

  private:
    struct Port {
        /// node of the port; nullptr: the port that receives every frame and sends the frames of put()
        BusNode* node{nullptr};
        Descriptor socket;
        std::vector<AcceptanceFilter> filters;
        std::uint32_t dropped{0};  ///< number of frames that the present socket has lost
        std::uint64_t lost{0};     ///< number of frames that all sockets of the port have lost
        bool overrun{false};
        CanState reported_state{CanState::error_active};
        Instant retry{never};
        Duration pause{};
        std::uint32_t bit_rate{0};
        std::deque<Frame> waiting;  ///< frames of put() that are not sent yet
    };
    struct Arrival {
        Instant time{};
        std::size_t port{0};
        can_frame frame{};
        bool lost_before{false};
        std::uint64_t order{0};  ///< number in the order of reading; decides between equal times
    };

    void open_sockets(Instant now);
    void open_socket(Port& port);
    void close_sockets();
    Instant read_socket(std::size_t port, Instant now);
    void count_losses(Port& port, std::uint32_t dropped);
    void tell_losses(Instant now);
    Instant arrival_time(std::uint64_t stamp_ns, Instant now);
    void take(const Arrival& arrival);
    void take_error(Port& port, const Arrival& arrival);
    void set_overrun(Port& port, bool lost, Instant now);
    void set_state(Port& port, CanState state, Instant now);
    void send_when_due(Port& port, Instant now);
    void send_waiting(Port& port, Instant now);
    const Frame* next_frame(const Port& port) const;
    void follow_node(Port& port);
    void change_bit_rate(const Port& port);
    void lose_interface(Instant now);
    void look_for_interface(Instant now);
    void restart_controller(Instant now);
    void count(const Frame& frame, Instant now);

    std::string interface_;
    CanSystem& system_;
    InterfaceControl control_;
    std::vector<Port> ports_;  ///< the first port receives every frame
    unsigned number_{0};
    bool down_{false};
    Instant look_at_{never};
    Instant restart_at_{never};
    bool restart_failure_told_{false};  ///< whether a refused restart of the present bus-off was reported
    Instant advanced_to_{};
    std::deque<Arrival> arrived_;
    Instant known_{};  ///< time up to which all arrivals are known
    std::uint64_t arrivals_{0};
    std::vector<CanReception> received_;  ///< frames of one system call
    bool roomy_{true};
    bool losses_are_news_{false};
    Instant losses_told_{never};
    struct Sender {
        const BusNode* node{nullptr};
        Instant time{};
    };
    EchoMatcher<Sender> own_;
    std::uint32_t bit_rate_{0};
    std::uint64_t frames_{0};
    std::uint64_t errors_{0};
    Duration worst_latency_{};
    BusLoad load_;
};

}  // namespace canproof::host
