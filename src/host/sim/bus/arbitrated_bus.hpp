// SPDX-License-Identifier: Apache-2.0
// The in-process bus. It transmits one frame at a time, and the lowest identifier goes first. Each frame takes the time
// of its bits. The bus is deterministic: the same frames at the same times and the same seed give the same traffic.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/sim/bus/bus.hpp"
#include "host/sim/bus/bus_faults.hpp"
#include "host/sim/bus/bus_load.hpp"
#include "host/sim/bus/fault_confinement.hpp"
#include "host/sim/bus/frame_readers.hpp"
#include "host/sim/bus/gateway.hpp"
#include "host/sim/bus/waiting_line.hpp"

namespace canproof::host {

/// A bus with up to 127 nodes and any number of gateways.
///
/// The bus has the bit rate of most of its nodes; on a tie it keeps its present rate. A node with another bit rate
/// neither sends nor receives. Every frame is acknowledged, because the world outside counts as a further node. If two
/// nodes send the same identifier at the same time, the node that was attached first wins. CANopen forbids this case;
/// on a real bus it would cause bit errors.
///
/// A node gets the frames that its filters accept. The work for a frame depends on the number of its receivers, not on
/// the number of nodes: a node that reports its changes is inspected only after a change.
class ArbitratedBus final : public Bus {
  public:
    static constexpr std::size_t most_nodes = 127;

    /// Makes a bus without nodes. `bit_rate`, in bit/s, applies until a node has another bit rate.
    ArbitratedBus(std::string interface, std::uint32_t bit_rate, const BusFaultRates& faults);

    /// Adds a node. Throws InputError for more than 127 nodes.
    void attach(BusNode& node) override;
    /// Adds a gateway; allowed at any time. A gateway waits eight bit times after each of its frames, as an
    /// error-passive node does. If a gateway is detached during its transmission, an error frame follows.
    void attach_gateway(Gateway& gateway);
    void detach_gateway(const Gateway& gateway);
    /// Returns whether the bus transmits a frame of that gateway or must repeat one. Such a frame is lost if the
    /// gateway is detached.
    bool is_sending(const Gateway& gateway) const;

    bool put(const Frame& frame, Instant now) override;
    std::vector<Watch> watches() const override { return {}; }
    Instant poll(Instant now) override { return now; }
    void advance(Instant now) override;
    Instant next_deadline() const override;
    BusReport report(Instant now) const override;
    const std::string& interface() const override { return interface_; }

    /// Switches the controller of that node bus-off at `now`, for 128 × 11 bit times. If the bus transmits a
    /// frame of the node, the frame is lost and the other nodes see an error.
    void switch_off(const BusNode& node, Instant now);

    /// Returns how often the bus has inspected a port so far. This is a measure of its work.
    std::uint64_t inspections() const { return inspections_; }

  private:
    using Nanoseconds = std::uint64_t;
    struct Port {
        BusNode* node{nullptr};
        std::size_t number{0};  ///< ports get ascending numbers in the order in which they are attached
        bool gateway{false};
        std::optional<Frame> repeated;  ///< frame that was corrupted and must be sent again
        FaultConfinement counters;
        CanState reported_state{CanState::error_active};
        bool overrun{false};
        std::uint32_t rate{0};       ///< bit rate of the node when it was last inspected
        Nanoseconds first_since{0};  ///< time at which the next frame became the first of the port's queue
        Nanoseconds may_send_from{0};
        Nanoseconds back_on_bus{0};  ///< time at which the bus-off state ends
        bool changed{false};         ///< whether changed_ contains the port

        const Frame* next() const { return repeated ? &*repeated : node->next_frame(); }
    };
    struct Transmission {
        Port* port{nullptr};
        Frame frame{};
        Nanoseconds start{0};
        Nanoseconds end{0};
        bool corrupted{false};
    };

    void add_port(BusNode& node, bool gateway);
    void look_again(Port& port);
    bool takes_part(const Port& port) const;
    Nanoseconds bits(unsigned count) const;
    void follow_bit_rates();
    void tell_bit_rates();
    void look(Nanoseconds now);
    void look_at(Port& port, Nanoseconds now);
    Instant may_start(const Port& port) const;
    bool complete(Nanoseconds now);
    void start(Nanoseconds now);
    Port* winner(Nanoseconds at);
    void deliver(const Transmission& done);
    void count_reception(const Port& sender, const Port* loser, Instant now);
    void end_corrupted(const Transmission& done);
    void tell_receivers_error(const Port& sender, Instant now);
    void break_off(Nanoseconds at);
    void recover(Nanoseconds now);
    void tell_state(Port& port, Instant now);

    std::string interface_;
    std::uint32_t bit_rate_;
    BusFaults faults_;
    std::map<std::size_t, Port> ports_;  ///< ports by their number; the first port sends the frames of put()
    std::size_t next_number_{0};
    std::vector<Port*> changed_;  ///< ports of nodes that report changes, and must now be inspected
    std::vector<Port*> watched_;  ///< ports of nodes that do not report changes; they are inspected in every step
    std::vector<Port*> off_;      ///< ports of nodes that are bus-off
    WaitingLine waiting_;         ///< ports that have a frame to send, by their numbers
    FrameReaders readers_;        ///< ports that receive a frame, by their numbers
    bool rates_differ_{false};    ///< whether a node's bit rate differs from `rate` of its port
    bool troubled_{false};        ///< whether an error counter of a receiver is not 0, or a receiver has lost a frame
    Gateway outside_;
    std::optional<Transmission> running_;
    Nanoseconds advanced_to_{0};
    Nanoseconds idle_from_{0};
    BusLoad load_;
    std::uint64_t frames_{0};
    std::uint64_t errors_{0};
    Nanoseconds worst_latency_{0};
    std::uint64_t inspections_{0};
};

}  // namespace canproof::host
