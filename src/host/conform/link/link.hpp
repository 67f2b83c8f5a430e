// SPDX-License-Identifier: Apache-2.0
// The tester's connection to the bus. It sends frames, keeps received frames until a step uses them, repeats frames in
// the background, and logs all frames.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "host/conform/link/bus_use.hpp"
#include "host/conform/link/target.hpp"

namespace canproof::host::conform {

/// The identifier, format and type (data or remote) of the frames that a step refers to.
struct FrameKey {
    std::uint32_t id{0};
    bool extended{false};
    bool remote{false};

    bool fits(const Frame& frame) const {
        return frame.id == id && frame.extended == extended && frame.remote == remote;
    }
};

/// The frames that were received from `since` on and that have one of the identifiers, formats and types in `keys`.
struct Watched {
    std::vector<FrameKey> keys;  ///< frames to collect; empty: all frames except the tester's own
    /// selects frames among those that `keys` names; empty: all of them
    std::function<bool(const FrameRecord&)> counts;
    Instant since{};
    std::vector<FrameRecord> frames;

    bool fits(const FrameRecord& record) const;
    /// Returns the times between successive frames in µs.
    std::vector<std::uint64_t> gaps() const;
};

class Link {
  public:
    /// Greatest number of frames in the log of a case. A case with more frames ends with the verdict `broken`.
    static constexpr std::size_t most_logged = 400000;

    explicit Link(Target& target);
    ~Link();
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    Target& target() { return target_; }
    Instant now() const { return target_.now(); }
    void send(const Frame& frame);
    void wait(Duration time) { wait_until(now() + time); }
    void wait_until(Instant until);

    /// Removes and returns the oldest received frame that `key` describes. Waits for such a frame until `deadline`;
    /// returns nothing when none comes.
    std::optional<FrameRecord> take(const FrameKey& key, Instant deadline);
    /// Returns the oldest received frame for which `wanted` returns true. Does not wait, and does not remove the frame.
    /// Returns nullptr when there is none.
    const FrameRecord* peek(const std::function<bool(const FrameRecord&)>& wanted) const;
    void forget() { inbox_.clear(); }
    void forget(const FrameKey& key);

    /// Collects frames that `wanted` describes until end_watch(). A step such as `expect` does not receive a collected
    /// frame. If several watches match a frame, only the newest watch collects it.
    std::shared_ptr<const Watched> watch(Watched wanted);
    void end_watch(const std::shared_ptr<const Watched>& watched);
    void end_watches();
    /// Waits until `done` returns true, but at most until `deadline`. Returns the last result of `done`.
    bool wait_for(const std::function<bool()>& done, Instant deadline);

    void produce(const Frame& frame, Duration period);
    void stop_producing();
    void stop_producing(std::uint32_t id);
    /// Sends background frames that use `percent` of the bus capacity; 0 sends none. With `high`, they have priority
    /// over the slave's PDOs, SDOs and heartbeat.
    void set_traffic(double percent, bool high);
    /// Excludes these identifiers from the background traffic, because the slave may use them.
    void reserve(std::set<std::uint32_t> ids) { reserved_ = std::move(ids); }

    /// Ends repeated frames, background traffic and watches, drops received frames, and starts an empty log.
    void begin_case();
    const std::vector<FrameRecord>& log() const { return log_; }
    /// Returns the numbers of frames and bits on the bus since the link was made.
    const BusUse& bus_use() const { return use_; }
    /// Calls `listener` with each frame that the tester sends.
    void on_send(std::function<void(const Frame&)> listener) { on_send_ = std::move(listener); }
    /// Returns the time at which a step last sent a frame; background frames do not count.
    Instant last_sent() const { return last_sent_; }
    /// Returns the greatest delay that the tester itself had since the case began, for example because the machine was
    /// busy. It is zero in virtual time.
    Duration worst_delay() const { return worst_delay_; }

  private:
    struct Produced {
        Frame frame{};
        Duration period{};
        Instant next{};
    };

    void take_in(const FrameRecord& record);
    void pass(Instant until);
    Instant next_background() const;
    void send_background();
    std::optional<Frame> traffic_frame();

    Target& target_;
    std::deque<FrameRecord> inbox_;
    std::vector<std::shared_ptr<Watched>> watches_;
    std::vector<FrameRecord> log_;
    BusUse use_;
    std::vector<Produced> produced_;
    std::set<std::uint32_t> reserved_;
    Duration traffic_period_{};
    bool traffic_high_{false};
    Instant next_traffic_{never};
    std::uint32_t traffic_number_{0};
    Instant last_sent_{};
    Frame last_frame_{};
    Duration worst_delay_{};
    std::function<void(const Frame&)> on_send_;
};

}  // namespace canproof::host::conform
