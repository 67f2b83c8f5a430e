// SPDX-License-Identifier: Apache-2.0
// Runs devices on a bus from event to event, in order of time. The owner of the clock decides how far the session
// advances; the session itself never waits. The behaviour of a device depends only on the times of frames and stimuli,
// so a replay of the logged frames and stimuli gives the same frames.
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

/// Receives the events of a session.
class SessionObserver {
  public:
    virtual ~SessionObserver() = default;
    virtual void on_frame(const BusFrame& frame) = 0;
    /// Is called after all events of the time `at`. States and outputs then have their new values.
    virtual void on_step(Instant at) = 0;
};

/// The streams for the outputs of a session. Each may be nullptr.
struct SessionOutputs {
    std::ostream* frames{nullptr};  ///< every frame as a line of candump
    std::ostream* log{nullptr};     ///< every frame in the format `log_format`
    LogFormat log_format{LogFormat::candump};
    std::ostream* outputs{nullptr};  ///< changes of outputs: `seconds,signal,value`, or with several devices
                                     ///< `seconds,device.signal,value`
    SessionObserver* observer{nullptr};
};

/// The number of frames that a node has sent, and the last of these frames.
struct NodeTraffic {
    std::uint64_t frames{0};
    std::optional<LoggedFrame> last;
};

class RunSession {
  public:
    /// Makes a session. A stimulus for `device.signal` acts on that device; a stimulus for `signal` acts on every
    /// device that has the signal.
    RunSession(std::unique_ptr<Bus> bus, std::vector<std::unique_ptr<DeviceNode>> nodes, std::vector<Stimulus> stimuli,
               const SessionOutputs& outputs);

    /// Switches the devices on at time 0. Stimuli for time 0 are applied first.
    void power_on();
    /// Handles all events up to `now`, each at its own time. Stops earlier when more data have arrived at the bus than
    /// one turn reads. Throws StuckDevice for a device whose deadline does not advance.
    void advance_to(Instant now);
    /// Handles events as advance_to(now) does, but stops when may_go_on() returns false after a step. now() is then
    /// earlier than the argument `now`.
    void advance_to(Instant now, const std::function<bool()>& may_go_on);
    Instant next_deadline() const;
    /// Sends a frame of the user. Returns false when the bus cannot take the frame now.
    bool put(const Frame& frame);
    /// Adds a stimulus of the user after those that are planned for the same time. A stimulus whose time has passed is
    /// applied next.
    void schedule(const Stimulus& stimulus);

    Bus& bus() { return *bus_; }
    const Bus& bus() const { return *bus_; }
    Instant now() const { return time_.now(); }
    const std::vector<std::unique_ptr<DeviceNode>>& nodes() const { return nodes_; }
    /// Returns the number of frames and the last frame of each node, in the order of nodes().
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
    std::vector<OutputChanges> changes_;  ///< last written outputs of each node, in the order of nodes_
    std::unordered_map<const BusNode*, std::size_t> numbers_;
    std::unordered_multimap<std::string, std::size_t> by_name_;
    Deadlines deadlines_;  ///< deadlines of the devices; can be out of date for devices in changed_
    /// numbers of the nodes that have changed since the last step; each occurs once
    std::vector<std::size_t> changed_;
    std::vector<bool> is_changed_;  ///< in the order of nodes_: whether changed_ contains the node
    ForwardTime time_;
};

}  // namespace canproof::host
