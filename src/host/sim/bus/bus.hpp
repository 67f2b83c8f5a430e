// A bus as the run loop sees it: nodes on the one side, descriptors and deadlines on the other.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "firmware/canopen/node.hpp"
#include "host/sim/bus/acceptance.hpp"

namespace canproof::host {

/// What a bus asks and tells one of its nodes.
class BusNode {
  public:
    virtual ~BusNode() = default;

    virtual const std::string& name() const = 0;
    /// The frame to be sent next; nullptr when there is none.
    virtual const Frame* next_frame() const = 0;
    /// That frame is on its way: the node forgets it.
    virtual void take_frame() = 0;
    virtual void receive(const Frame& frame, Instant now) = 0;
    virtual void set_can_state(CanState state, Instant now) = 0;
    /// A frame for this node was lost for want of room; false when that has ended.
    virtual void set_overrun(bool lost, Instant now) = 0;
    /// The frames that the node may react to; changes as it is configured.
    virtual const std::vector<AcceptanceFilter>& filters() const = 0;
    /// bit/s that its CAN controller works at; 0: whatever the bus has.
    virtual std::uint32_t bit_rate() const = 0;
    /// Whether it says when its next frame, its filters or its bit rate may be others. A bus looks at another node
    /// again and again.
    virtual bool tells_changes() const { return false; }

    /// Has `listener` called at each such change; as long as the node lives.
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

/// A frame that went over the bus.
struct BusFrame {
    Instant time{};
    Frame frame{};
    const BusNode* sender{nullptr};  ///< nullptr: it came from outside
};

/// What has happened on a bus so far.
struct BusReport {
    std::uint64_t frames{0};
    std::uint64_t errors{0};     ///< error frames
    std::uint64_t lost{0};       ///< frames that came faster than they were read: neither logged nor counted
    std::uint64_t missed{0};     ///< the same, of frames meant for nodes here
    double load{0.0};            ///< 0…1, over the last second
    Duration worst_latency{};    ///< from when a frame stood first in its node's queue until its last bit
    std::uint32_t bit_rate{0U};  ///< bit/s; 0: not known
};

/// A descriptor that a bus waits for.
struct Watch {
    int descriptor{-1};
    bool readable{true};
    bool writable{false};
};

using FrameListener = std::function<void(const BusFrame&)>;
using NoticeListener = std::function<void(const std::string&)>;

/// Everything happens in advance(), in order of time; poll() only takes in what has arrived. Neither waits.
class Bus {
  public:
    virtual ~Bus() = default;

    /// `node` must outlive the bus. Before the first advance().
    virtual void attach(BusNode& node) = 0;
    /// Sends a frame of nobody's (a line on standard input). False when it cannot be taken now.
    virtual bool put(const Frame& frame, Instant now) = 0;
    virtual std::vector<Watch> watches() const = 0;
    /// Reads the descriptors; what came is due at the time at which it came. Gives the time up to which everything that
    /// came is known: `now`, or earlier when there was more than one turn reads.
    virtual Instant poll(Instant now) = 0;
    virtual void advance(Instant now) = 0;
    virtual Instant next_deadline() const = 0;
    virtual BusReport report(Instant now) const = 0;
    /// Name of the interface as a log shows it.
    virtual const std::string& interface() const = 0;

    /// Is told every frame once, in order of time.
    void listen(FrameListener listener) { listener_ = std::move(listener); }
    /// Is told what the user should know: "vcan0 is down; waiting for it".
    void on_notice(NoticeListener listener) { notice_ = std::move(listener); }

  protected:
    void tell(const BusFrame& frame) const {
        if (listener_) {
            listener_(frame);
        }
    }
    void notice(const std::string& text) const {
        if (notice_) {
            notice_(text);
        }
    }

  private:
    FrameListener listener_;
    NoticeListener notice_;
};

}  // namespace canproof::host
