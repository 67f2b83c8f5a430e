// The in-process bus: one frame at a time, the lowest identifier first, each as long as its bits take. Deterministic:
// the same frames at the same times, and the same seed, give the same traffic.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/sim/bus/bus.hpp"
#include "host/sim/bus/bus_faults.hpp"
#include "host/sim/bus/fault_confinement.hpp"
#include "host/sim/bus/gateway.hpp"

namespace canproof::host {

/// Up to 127 nodes and any number of gateways. Nodes whose controller works at another bit rate than the bus hear and
/// say nothing; the bus has the rate that most of its nodes have, and keeps what it has on a tie. Every frame is
/// acknowledged: the world outside is one more station. Of two nodes that send the same identifier at once the one that
/// was attached first goes first; CANopen forbids it, and a real bus would punish it with bit errors.
class ArbitratedBus final : public Bus {
  public:
    static constexpr std::size_t most_nodes = 127;

    /// `bit_rate` in bit/s holds until a node says otherwise.
    ArbitratedBus(std::string interface, std::uint32_t bit_rate, const BusFaultRates& faults);

    /// Throws InputError for a 128th node.
    void attach(BusNode& node) override;
    /// A door to the outside may come and go at any time. Behaves as an error-passive node does: after each frame it
    /// leaves eight bit times to the others. One that goes while its frame is on the wire leaves an error frame behind.
    void attach_gateway(Gateway& gateway);
    void detach_gateway(const Gateway& gateway);
    /// A frame of that door is on the wire, or must be repeated: it would be lost with the door.
    bool is_sending(const Gateway& gateway) const;

    bool put(const Frame& frame, Instant now) override;
    std::vector<Watch> watches() const override { return {}; }
    Instant poll(Instant now) override { return now; }
    void advance(Instant now) override;
    Instant next_deadline() const override;
    BusReport report(Instant now) const override;
    const std::string& interface() const override { return interface_; }

    /// From `now` on the controller of that node is bus-off, for 128 × 11 bit times. Its frame on the wire is lost, and
    /// the others see an error.
    void switch_off(const BusNode& node, Instant now);

  private:
    using Nanoseconds = std::uint64_t;
    struct Port {
        BusNode* node{nullptr};
        bool gateway{false};
        std::optional<Frame> repeated;  ///< was corrupted, and is sent again
        FaultConfinement counters;
        CanState told{CanState::error_active};
        bool overrun{false};
        std::uint32_t rate{0};       ///< of the node, when last looked at
        Nanoseconds first_since{0};  ///< when the frame that is sent next became so
        bool waits{false};
        Nanoseconds may_send_from{0};
        Nanoseconds back_on_bus{0};  ///< while bus-off

        const Frame* next() const { return repeated ? &*repeated : node->next_frame(); }
    };
    struct Transmission {
        std::size_t port{0};
        Frame frame{};
        Nanoseconds start{0};
        Nanoseconds end{0};
        bool corrupted{false};
    };
    struct Busy {
        Nanoseconds start;
        Nanoseconds end;
    };

    Port& add_port(BusNode& node, bool gateway);
    bool takes_part(const Port& port) const;
    Nanoseconds bits(unsigned count) const;
    void follow_bit_rates();
    void tell_bit_rates();
    void note_waiting(Nanoseconds now);
    bool complete(Nanoseconds now);
    bool start(Nanoseconds now);
    Port* winner(Nanoseconds at);
    void deliver(const Transmission& done);
    void end_corrupted(const Transmission& done);
    void tell_receivers_error(const Port& sender, Instant now);
    void break_off(Nanoseconds at);
    void recover(Nanoseconds now);
    void tell_state(Port& port, Instant now);
    void set_overrun(Port& port, bool lost, Instant now);

    std::string interface_;
    std::uint32_t bit_rate_;
    BusFaults faults_;
    std::vector<std::unique_ptr<Port>> ports_;  ///< in order of attachment; that of put() first
    Gateway outside_;
    std::optional<Transmission> running_;
    Nanoseconds advanced_to_{0};
    Nanoseconds idle_from_{0};
    std::deque<Busy> busy_;  ///< of the last second
    std::uint64_t frames_{0};
    std::uint64_t errors_{0};
    Nanoseconds worst_latency_{0};
};

}  // namespace canproof::host
