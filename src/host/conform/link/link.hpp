// The tester's end of the bus: sends, keeps what came until a step takes it, repeats frames in the background, and
// keeps a log.
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

/// Which frames a step means.
struct FrameKey {
    std::uint32_t id{0};
    bool extended{false};
    bool remote{false};

    bool fits(const Frame& frame) const {
        return frame.id == id && frame.extended == extended && frame.remote == remote;
    }
};

/// Frames of one kind, collected from some time on.
struct Watched {
    std::vector<FrameKey> keys;                      ///< none: all frames that are not the tester's
    std::function<bool(const FrameRecord&)> counts;  ///< empty: all of that kind
    Instant since{};
    std::vector<FrameRecord> frames;

    bool fits(const FrameRecord& record) const;
    /// Microseconds between each frame and the one after it.
    std::vector<std::uint64_t> gaps() const;
};

class Link {
  public:
    /// More frames in one case end it.
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

    /// The oldest frame of that kind that nobody took; waits for one until `deadline`.
    std::optional<FrameRecord> take(const FrameKey& key, Instant deadline);
    /// The same without waiting and taking; nullptr when there is none.
    const FrameRecord* peek(const std::function<bool(const FrameRecord&)>& wanted) const;
    void forget() { inbox_.clear(); }
    void forget(const FrameKey& key);

    /// Collects until end_watch(); what it collects nobody else gets, but a newer watch comes first.
    std::shared_ptr<const Watched> watch(Watched wanted);
    void end_watch(const std::shared_ptr<const Watched>& watched);
    /// Waits until `done` or until `deadline`; whether it was `done`.
    bool wait_for(const std::function<bool()>& done, Instant deadline);

    void produce(const Frame& frame, Duration period);
    void stop_producing();
    void stop_producing(std::uint32_t id);
    /// Foreign frames that make up `percent` of the bus; 0: none. `high`: they win over the slave's.
    void set_traffic(double percent, bool high);
    /// Identifiers that the slave may listen to: no traffic.
    void reserve(std::set<std::uint32_t> ids) { reserved_ = std::move(ids); }

    /// Ends background and watches, forgets what came, and begins an empty log.
    void begin_case();
    const std::vector<FrameRecord>& log() const { return log_; }
    /// All frames since the link was made.
    const BusUse& bus_use() const { return use_; }
    /// Is told each frame that the tester sends.
    void on_send(std::function<void(const Frame&)> listener) { on_send_ = std::move(listener); }
    /// When the last frame of a step went over the bus.
    Instant last_sent() const { return last_sent_; }
    /// How late the tester itself has been at most since the case began: a busy machine. Zero in virtual time.
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
    Frame traffic_frame();

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
