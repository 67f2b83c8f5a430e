// SPDX-License-Identifier: Apache-2.0
#include "host/sim/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "host/base/input_error.hpp"
#include "host/base/time_text.hpp"
#include "host/sim/bus/frame_text.hpp"
#include "host/sim/devices/advance_device.hpp"
#include "host/sim/devices/forward_time.hpp"
#include "host/sim/replay/output_changes.hpp"
#include "host/sim/replay/own_frames.hpp"

namespace canproof::host {

namespace {

/// Longest time for which a sent frame waits until the log contains it. After this time, the frame is written with the
/// time at which the device sent it.
constexpr Duration longest_hold = milliseconds(1000);

FrameSource source_of(const ReplayInput& input) {
    if (input.source) {
        return input.source;
    }
    return [&frames = input.frames, next = std::size_t{0}](LoggedFrame& frame) mutable {
        if (next == frames.size()) {
            return false;
        }
        frame = frames[next++];
        return true;
    };
}

/// Plays a log to a device. The time of the device begins at 0. The time of the log is greater by `shift_`.
class Player {
  public:
    Player(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out)
        : device_{device},
          input_{input},
          source_{source_of(input)},
          frames_out_{frames_out},
          outputs_out_{outputs_out} {}

    void run() {
        if (outputs_out_ != nullptr) {
            *outputs_out_ << output_heading;
        }
        take_next_frame();
        interface_ = has_frame_ ? frame_.interface : "can0";
        is_marked_ = has_frame_ && frame_.mark != LogMark::none;
        begin();
        device_.power_on(Instant{});
        report();
        for (Instant due = next(); due != never; due = next()) {
            step(time_.reach(due));
        }
        tell_short_end();
        release_all();
    }

  private:
    /// Determines the start and skips the frames before the start. Applies the stimuli up to the start, because they
    /// describe the environment at power-on.
    void begin() {
        const Instant first = has_frame_ ? frame_.time : Instant{};
        const Instant start = input_.start.value_or(latest_zero < first ? first : Instant{});
        if (input_.until && *input_.until < start) {
            throw InputError{
                fmt::format("--until {} is before the start at {}; write a later --until or an earlier --start",
                            format_seconds(*input_.until), format_seconds(start))};
        }
        if (!input_.start && start != Instant{}) {
            tell(fmt::format(
                "power-on is at {}, the time of the first frame of the log; --start SECONDS sets another time",
                format_seconds(start)));
        }
        std::size_t left_out = 0;
        for (; has_frame_ && frame_.time < start; take_next_frame()) {
            ++left_out;
        }
        if (left_out != 0) {
            tell(fmt::format("{} frames before the start are left out", left_out));
        }
        shift_ = start.us;
        while (has_stimulus() && stimulus().time <= start) {
            stimulate();
        }
    }

    bool has_stimulus() const { return next_stimulus_ < input_.stimuli.size(); }
    const Stimulus& stimulus() const { return input_.stimuli[next_stimulus_]; }
    void take_next_frame() { has_frame_ = source_(frame_); }
    Instant log_time(Instant device_time) const { return Instant{device_time.us + shift_}; }

    /// Returns the time of the next line of log or stimuli, in the log's time.
    Instant next_line() const {
        const Instant line = earliest(has_frame_ ? frame_.time : never, has_stimulus() ? stimulus().time : never);
        const bool is_over = input_.until && *input_.until < line;
        return is_over ? never : line;
    }

    /// Converts a time of the log to the time of the device. A silence longer than longest_silence is shortened to
    /// longest_silence.
    Instant due_of(Instant line) const { return earliest(Instant{line.us - shift_}, last_line_ + longest_silence); }

    Instant next() const {
        const Instant line = next_line();
        if (line != never) {
            return earliest(device_.next_deadline(), due_of(line));
        }
        const Instant end = input_.until ? earliest(device_end(), latest_end()) : last_line_;
        const Instant due = device_.next_deadline();
        return end < due ? never : due;
    }

    /// Returns the end that --until sets, in the time of the device.
    Instant device_end() const { return Instant{input_.until->us - std::min(shift_, input_.until->us)}; }
    /// Returns the time of the device up to which a replay plays a silence of the log in which --until is. Behind the
    /// last line of the log, the user asks for this time, and nothing is shortened.
    Instant latest_end() const {
        const bool is_before_line = has_frame_ || has_stimulus();
        return is_before_line ? last_line_ + longest_silence : never;
    }
    /// Tells the user when the replay leaves out a part of the silence before --until.
    void tell_short_end() const {
        if (input_.until && latest_end() < device_end()) {
            tell(fmt::format("nothing happens before {}; the replay leaves out {} s", format_seconds(*input_.until),
                             (device_end().us - latest_end().us) / 1000000U));
        }
    }

    void step(Instant now) {
        if (device_.next_deadline() <= now) {
            announce_call();
            advance_device(device_, "the device", now);
            report();
        }
        for (Instant line = next_line(); line != never && due_of(line) <= now; line = next_line()) {
            pass_silence(line, now);
            if (has_stimulus() && stimulus().time == line) {
                stimulate();
            } else {
                receive();
            }
            report();
        }
    }

    void pass_silence(Instant line, Instant now) {
        const std::uint64_t shift = std::max(shift_, line.us - std::min(now.us, line.us));
        if (shift > shift_) {
            tell(fmt::format("nothing happens before {}; the replay leaves out {} s", format_seconds(line),
                             (shift - shift_) / 1000000U));
        }
        shift_ = shift;
        last_line_ = now;
    }

    void receive() {
        const bool may_be_own = frame_.mark != LogMark::received;
        if (may_be_own && own_.match(frame_.frame, time_.now())) {
            write_held();
        } else {
            announce_call();
            device_.receive(frame_.frame, time_.now());
        }
        take_next_frame();
    }

    void stimulate() {
        const Stimulus& one = stimulus();
        ++next_stimulus_;
        announce_call();
        if (!device_.set_input(one.signal, one.value, time_.now())) {
            throw InputError{
                fmt::format("stimulus at {} s: there is no input `{}`; `canproof signals` lists the inputs",
                            format_seconds(one.time), one.signal)};
        }
    }

    void report() {
        const Instant now = log_time(time_.now());
        while (!device_.queue().empty()) {
            const Frame frame = device_.queue().pop();
            own_.sent(frame, time_.now());
            if (is_marked_) {
                held_.push_back({now, interface_, frame});
            } else {
                write({now, interface_, frame});
            }
        }
        while (!held_.empty() && held_.front().time + longest_hold < now) {
            write(held_.front());
            held_.pop_front();
        }
        if (outputs_out_ != nullptr) {
            outputs_.write(*outputs_out_, now, device_);
        }
    }

    /// Writes the frame of `held_` that equals the present frame of the log, if there is one, with the log's time.
    void write_held() {
        const auto found = std::find_if(held_.begin(), held_.end(),
                                        [this](const LoggedFrame& one) { return are_alike(one.frame, frame_.frame); });
        if (found != held_.end()) {
            held_.erase(found);
            write({frame_.time, interface_, frame_.frame});
        }
    }

    void release_all() {
        for (const LoggedFrame& one : held_) {
            write(one);
        }
    }

    void write(const LoggedFrame& frame) { frames_out_ << format_candump_line(frame) << '\n'; }
    void announce_call() const {
        if (input_.before_call) {
            input_.before_call();
        }
    }
    void tell(const std::string& text) const {
        if (input_.notice) {
            input_.notice(text);
        }
    }

    SimulatedDevice& device_;
    const ReplayInput& input_;
    FrameSource source_;
    std::ostream& frames_out_;
    std::ostream* outputs_out_;
    LoggedFrame frame_;  ///< next frame of the log; valid if has_frame_ is true
    bool has_frame_{false};
    std::size_t next_stimulus_{0};
    std::string interface_;
    bool is_marked_{false};
    ForwardTime time_;
    Instant last_line_{};
    std::uint64_t shift_{0};
    OutputChanges outputs_;
    OwnFrames own_;
    /// frames that the device has sent, and that a log with T and R has not contained yet
    std::deque<LoggedFrame> held_;
};

}  // namespace

void replay(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out) {
    Player{device, input, frames_out, outputs_out}.run();
}

}  // namespace canproof::host
