// The in-process bus: one frame at a time, the lowest identifier first, each as long as its bits take. Deterministic:
// the same frames at the same times, and the same seed, give the same traffic.
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

/// Up to 127 nodes and any number of gateways. Nodes whose controller works at another bit rate than the bus hear and
/// say nothing; the bus has the rate that most of its nodes have, and keeps what it has on a tie. Every frame is
/// acknowledged: the world outside is one more station. Of two nodes that send the same identifier at once the one that
/// was attached first goes first; CANopen forbids it, and a real bus would punish it with bit errors.
///
/// A node gets the frames that its filters let through. What a frame costs follows its receivers, not the number of
/// nodes: a node that tells its changes is looked at after a change only.
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
        std::size_t number{0};  ///< ascends in order of attachment
        bool gateway{false};
        std::optional<Frame> repeated;  ///< was corrupted, and is sent again
        FaultConfinement counters;
        CanState told{CanState::error_active};
        bool overrun{false};
        std::uint32_t rate{0};       ///< of the node, when last looked at
        Nanoseconds first_since{0};  ///< when the frame that is sent next became so
        Nanoseconds may_send_from{0};
        Nanoseconds back_on_bus{0};  ///< while bus-off
        bool changed{false};         ///< stands in changed_

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
    bool start(Nanoseconds now);
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
    std::map<std::size_t, Port> ports_;  ///< by number; that of put() first
    std::size_t next_number_{0};
    std::vector<Port*> changed_;  ///< of nodes that tell changes: to be looked at
    std::vector<Port*> watched_;  ///< of nodes that do not
    std::vector<Port*> off_;      ///< bus-off
    WaitingLine waiting_;         ///< by number
    FrameReaders readers_;        ///< by number
    bool rates_differ_{false};    ///< a node has another bit rate than was told
    bool troubled_{false};        ///< an error counter of a receiver is not 0, or one has lost a frame
    Gateway outside_;
    std::optional<Transmission> running_;
    Nanoseconds advanced_to_{0};
    Nanoseconds idle_from_{0};
    BusLoad load_;
    std::uint64_t frames_{0};
    std::uint64_t errors_{0};
    Nanoseconds worst_latency_{0};
};

}  // namespace canproof::host
