// SPDX-License-Identifier: Apache-2.0
// The interface of a bus for the run loop. A bus connects nodes; the run loop waits for its descriptors and deadlines.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "firmware/canopen/node.hpp"
#include "host/sim/bus/acceptance.hpp"
#include "host/sim/bus/arrival_clock.hpp"

namespace canproof::host {

/// The functions of a node that its bus calls.
class BusNode {
  public:
    virtual ~BusNode() = default;

    virtual const std::string& name() const = 0;
    /// Returns the next frame to send; nullptr when there is none.
    virtual const Frame* next_frame() const = 0;
    /// Removes the next frame, because its transmission has started.
    virtual void take_frame() = 0;
    virtual void receive(const Frame& frame, Instant now) = 0;
    virtual void set_can_state(CanState state, Instant now) = 0;
    /// Reports whether the last frame for this node was lost because the receive buffer had no room.
    virtual void set_overrun(bool lost, Instant now) = 0;
    /// Returns the filters for the frames to which the node reacts. They change with the node's configuration.
    virtual const std::vector<AcceptanceFilter>& filters() const = 0;
    /// Returns the bit rate of the node's CAN controller in bit/s; 0 when the node has no bit rate of its own.
    virtual std::uint32_t bit_rate() const = 0;
    /// Returns whether the node calls its listeners when its next frame, its filters or its bit rate may have changed.
    /// If it does not, a bus inspects the node in every step.
    virtual bool tells_changes() const { return false; }

    /// Adds a listener, which the node calls after a change of its next frame, its filters or its bit rate.
    void on_change(std::function<void()> listener) { listeners_.push_back(std::move(listener)); }

  protected:
    void tell_change() const {
        for (const auto& listener : listeners_) {
            listener();
        }
    }

  private:
    std::vector<std::function<void()>> listeners_;
};

/// A frame that the bus has transmitted.
struct BusFrame {
    Instant time{};
    Frame frame{};
    const BusNode* sender{nullptr};  ///< node that has sent the frame; nullptr: the frame came from outside
};

/// The statistics of a bus since its start.
struct BusReport {
    std::uint64_t frames{0};
    std::uint64_t errors{0};  ///< number of error frames
    /// number of frames that came faster than they were read; they are neither logged nor counted
    std::uint64_t lost{0};
    /// number of frames that nodes of this program have lost, each counted once for each node
    std::uint64_t missed{0};
    double load{0.0};  ///< load over the last second, 0 to 1
    /// longest time from the moment a frame becomes the first in the queue of its node until its last bit is sent
    Duration worst_latency{};
    std::uint32_t bit_rate{0U};  ///< bit rate in bit/s; 0: unknown
};

/// A descriptor for which the run loop waits on behalf of a bus.
struct Watch {
    int descriptor{-1};
    bool readable{true};
    bool writable{false};
};

using FrameListener = std::function<void(const BusFrame&)>;
using NoticeListener = std::function<void(const std::string&)>;

/// A bus. All events happen in advance(), in order of time; poll() only reads arrived data. Neither function waits.
class Bus {
  public:
    virtual ~Bus() = default;

    /// Adds a node. Must be called before the first advance(). `node` must outlive the bus.
    virtual void attach(BusNode& node) = 0;
    /// Sends a frame that belongs to no node, such as a line on standard input. Returns false when the bus cannot take
    /// the frame now.
    virtual bool put(const Frame& frame, Instant now) = 0;
    virtual std::vector<Watch> watches() const = 0;
    /// Reads the descriptors. Arrived data become due at their time of arrival. Returns the time up to which all
    /// arrivals are known: `now`, or an earlier time if more data have arrived than one call reads.
    virtual Instant poll(Instant now) = 0;
    virtual void advance(Instant now) = 0;
    virtual Instant next_deadline() const = 0;
    virtual BusReport report(Instant now) const = 0;
    /// Returns the name of the interface for a log.
    virtual const std::string& interface() const = 0;

    /// Sets the clock of the run. A bus to the outside needs it to determine when data arrived. Without this clock, all
    /// data that poll(now) reads count as arrived at `now`.
    void use_clock(ArrivalClock::Clock clock);
    /// Sets the listener. It receives every frame once, in order of time.
    void listen(FrameListener listener);
    /// Sets the listener for messages to the user, such as "vcan0 is down; waiting for it".
    void on_notice(NoticeListener listener);

  protected:
    /// Passes a frame to the listener.
    void tell(const BusFrame& frame) const;
    /// Passes a message to the listener for messages.
    void notice(const std::string& text) const;

    ArrivalClock& arrival_clock() { return arrival_clock_; }
    const ArrivalClock& arrival_clock() const { return arrival_clock_; }

  private:
    FrameListener listener_;
    NoticeListener notice_;
    ArrivalClock arrival_clock_;
};

}  // namespace canproof::host
