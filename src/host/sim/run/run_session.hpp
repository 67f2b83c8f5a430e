// Devices on a bus, from event to event in order of time. Whoever owns the clock says how far; nothing here waits. What
// a device sees depends on the times of frames and stimuli alone, so that a log of them replays to the same frames.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <unordered_map>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/bus.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/forward_time.hpp"
#include "host/sim/replay/output_changes.hpp"
#include "host/sim/replay/stimulus.hpp"
#include "host/sim/run/deadlines.hpp"
#include "host/sim/run/device_node.hpp"
#include "host/sim/run/frame_log.hpp"

namespace canproof::host {

/// Is told what a session does, as it happens.
class SessionObserver {
  public:
    virtual ~SessionObserver() = default;
    virtual void on_frame(const BusFrame& frame) = 0;
    /// Everything of that time is done: states and outputs are those from now on.
    virtual void on_step(Instant at) = 0;
};

/// Where a session writes; each may be nullptr.
struct SessionOutputs {
    std::ostream* frames{nullptr};  ///< every frame as a candump line
    std::ostream* log{nullptr};     ///< the same in log_format
    LogFormat log_format{LogFormat::candump};
    std::ostream* outputs{nullptr};  ///< `seconds,signal,value`; `device.signal` when there are several devices
    SessionObserver* observer{nullptr};
};

/// What is known of a node's traffic.
struct NodeTraffic {
    std::uint64_t frames{0};
    std::optional<LoggedFrame> last;
};

class RunSession {
  public:
    /// A stimulus named `device.signal` acts on that device, another on every device that has the signal.
    RunSession(std::unique_ptr<Bus> bus, std::vector<std::unique_ptr<DeviceNode>> nodes, std::vector<Stimulus> stimuli,
               const SessionOutputs& outputs);

    /// Power-on at 0; stimuli at 0 come before it.
    void power_on();
    /// Everything that is due up to `now`, each at its own time; less far when the bus has more than one turn reads.
    /// Throws StuckDevice for a device that does not do what is due.
    void advance_to(Instant now);
    /// The same, but no further once may_go_on() is false after a step: now() is then earlier.
    void advance_to(Instant now, const std::function<bool()>& may_go_on);
    Instant next_deadline() const;
    /// A frame from the user. False when the bus cannot take it now.
    bool put(const Frame& frame);
    /// A stimulus from the user, behind what is planned for that time; one that is late comes next.
    void schedule(const Stimulus& stimulus);

    Bus& bus() { return *bus_; }
    const Bus& bus() const { return *bus_; }
    Instant now() const { return time_.now(); }
    const std::vector<std::unique_ptr<DeviceNode>>& nodes() const { return nodes_; }
    /// Parallel to nodes().
    const std::vector<NodeTraffic>& traffic() const { return traffic_; }

  private:
    void advance_known(Instant now, const std::function<bool()>& may_go_on);
    void step(Instant at);
    void stimulate(Instant at);
    void note_change(std::size_t number);
    void follow_deadlines();
    void record(const BusFrame& frame);
    void write_outputs(Instant at);
    void observe(Instant at);

    std::unique_ptr<Bus> bus_;
    std::vector<std::unique_ptr<DeviceNode>> nodes_;
    std::vector<NodeTraffic> traffic_;
    std::vector<Stimulus> stimuli_;
    std::size_t next_stimulus_{0};
    SessionOutputs outputs_;
    FrameLog log_;
    std::vector<OutputChanges> changes_;  ///< parallel to nodes_
    std::unordered_map<const BusNode*, std::size_t> numbers_;
    std::unordered_multimap<std::string, std::size_t> by_name_;
    Deadlines deadlines_;               ///< of the devices; never of those in changed_
    std::vector<std::size_t> changed_;  ///< nodes that something was done to since the last step, each once
    std::vector<bool> is_changed_;      ///< parallel to nodes_: stands in changed_
    ForwardTime time_;
};

}  // namespace canproof::host
