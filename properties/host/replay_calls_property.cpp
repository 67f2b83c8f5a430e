// SPDX-License-Identifier: Apache-2.0
// Compares a replay with a naive replay, which goes through one list of all lines. Both must call the device in the
// same way and have the same output.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "host/sim/replay/replay.hpp"
#include "tests/host/sim/replay/recording_device.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t second = 1000000;
constexpr std::uint64_t hour = 3600 * second;
const char* const beat = "705#7F";

std::string time_text(std::uint64_t us) {
    return fmt::format("{}.{:06}", us / second, us % second);
}

/// A line of the log (a frame) or of the stimuli.
struct Line {
    std::uint64_t us{0};
    bool is_frame{false};
    std::string text;  ///< the frame, or the name of the input
    double value{0.0};
    std::string mark;
    std::string interface;
};

struct Scene {
    std::vector<Line> frames;
    std::vector<Line> stimuli;
    std::uint64_t period{0};  ///< period in us in which the device sends a frame by itself; 0: it sends none
    std::optional<std::uint64_t> start;
    std::optional<std::uint64_t> until;
};

/// A naive replay, line by line. The device answers frame 300h with 301h and sends one frame in each period.
class NaiveReplay {
  public:
    explicit NaiveReplay(const Scene& scene) : scene_{scene} {}

    void run() {
        const bool is_late = !scene_.frames.empty() && scene_.frames.front().us > hour;
        interface_ = scene_.frames.empty() ? "can0" : scene_.frames.front().interface;
        const std::uint64_t start = scene_.start.value_or(is_late ? scene_.frames.front().us : 0U);
        is_marked_ = !scene_.frames.empty() && !scene_.frames.front().mark.empty();
        shift_ = start;
        tell_start(start);
        outputs = "seconds,signal,value\n";
        for (const Line& line : scene_.stimuli) {
            if (line.us <= start) {
                stimulate(line);
            }
        }
        told.push_back(time_text(0) + " on");
        report(true);
        for (const Line& line : lines_after(start)) {
            if (!scene_.until || line.us <= *scene_.until) {
                play(line);
            } else {
                ends_in_silence_ = true;
            }
        }
        end();
        for (const auto& [us, frame] : held_) {
            write(us, frame);
        }
    }

    std::vector<std::string> told;
    std::vector<std::string> notices;
    std::string frames;
    std::string outputs;

  private:
    void tell_start(std::uint64_t start) {
        if (!scene_.start && start != 0U) {
            notices.push_back(fmt::format(
                "power-on is at {}, the time of the first frame of the log; --start SECONDS sets another time",
                time_text(start)));
        }
        const auto left_out = std::count_if(scene_.frames.begin(), scene_.frames.end(),
                                            [&](const Line& line) { return line.us < start; });
        if (left_out != 0) {
            notices.push_back(fmt::format("{} frames before the start are left out", left_out));
        }
    }
    /// Returns the frames at or after `start` and the stimuli after `start`, by time. At equal times, stimuli come
    /// first.
    std::vector<Line> lines_after(std::uint64_t start) const {
        std::vector<Line> all;
        for (const auto* const lines : {&scene_.stimuli, &scene_.frames}) {
            for (const Line& line : *lines) {
                const auto later =
                    std::find_if(all.begin(), all.end(), [&](const Line& one) { return one.us > line.us; });
                if (line.us > start || (line.us == start && line.is_frame)) {
                    all.insert(later, line);
                }
            }
        }
        return all;
    }
    void end() {
        std::uint64_t end = scene_.until ? *scene_.until - std::min(shift_, *scene_.until) : last_;
        if (ends_in_silence_ && last_ + hour < end) {
            notices.push_back(fmt::format("nothing happens before {}; the replay leaves out {} s",
                                          time_text(*scene_.until), (end - last_ - hour) / second));
            end = last_ + hour;
        }
        work_until(end);
    }
    void play(const Line& line) {
        const std::uint64_t due = std::min(line.us - shift_, last_ + hour);
        work_until(due);
        now_ = std::max(now_, due);
        if (line.us - now_ > shift_) {
            notices.push_back(fmt::format("nothing happens before {}; the replay leaves out {} s", time_text(line.us),
                                          (line.us - now_ - shift_) / second));
            shift_ = line.us - now_;
        }
        last_ = now_;
        if (line.is_frame) {
            receive(line);
        } else {
            stimulate(line);
        }
        report(false);
    }
    void work_until(std::uint64_t end) {
        for (; scene_.period != 0 && next_work() <= end; ++done_) {
            now_ = next_work();
            told.push_back(time_text(now_) + " due");
            send(beat);
            report(false);
        }
    }
    std::uint64_t next_work() const { return (done_ + 1U) * scene_.period; }

    void stimulate(const Line& line) {
        told.push_back(fmt::format("{} {}={}", time_text(now_), line.text, line.value));
        values_[line.text == "one" ? 0 : 1] = line.value;
    }
    void receive(const Line& line) {
        if (line.mark != " R" && is_own(line.text)) {
            const auto held =
                std::find_if(held_.begin(), held_.end(), [&](const auto& one) { return one.second == line.text; });
            if (held != held_.end()) {
                held_.erase(held);
                write(line.us, line.text);
            }
            return;
        }
        told.push_back(time_text(now_) + " " + line.text);
        if (line.text.rfind("300#", 0) == 0) {
            send("301" + line.text.substr(3));
        }
    }
    /// Returns whether `frame` is the echo of a frame that the device sent in the last minute. Removes the oldest such
    /// frame.
    bool is_own(const std::string& frame) {
        for (auto one = own_.begin(); one != own_.end(); ++one) {
            if (one->second == frame && one->first + 60U * second >= now_) {
                own_.erase(one);
                return true;
            }
        }
        return false;
    }

    void send(const std::string& frame) { new_.push_back(frame); }
    void report(bool first) {
        const std::uint64_t at = now_ + shift_;
        for (const std::string& frame : new_) {
            own_.emplace_back(now_, frame);
            if (is_marked_) {
                held_.emplace_back(at, frame);
            } else {
                write(at, frame);
            }
        }
        new_.clear();
        while (!held_.empty() && held_.front().first + second < at) {
            write(held_.front().first, held_.front().second);
            held_.erase(held_.begin());
        }
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            if (first || values_[i] != written_[i]) {
                outputs += fmt::format("{},{},{}\n", time_text(at), i == 0 ? "one" : "two", values_[i]);
            }
        }
        written_ = values_;
    }
    void write(std::uint64_t us, const std::string& frame) {
        frames += fmt::format("({}) {} {}\n", time_text(us), interface_, frame);
    }

    const Scene& scene_;
    bool is_marked_{false};
    bool ends_in_silence_{false};  ///< the log goes on after the end of the replay
    std::string interface_;
    std::uint64_t shift_{0};
    std::uint64_t now_{0};
    std::uint64_t last_{0};
    std::uint64_t done_{0};
    std::vector<std::string> new_;
    std::vector<std::pair<std::uint64_t, std::string>> own_;
    std::vector<std::pair<std::uint64_t, std::string>> held_;
    std::vector<double> values_{0.0, 0.0};
    std::vector<double> written_{0.0, 0.0};
};

std::uint64_t any_gap(bool is_long) {
    return is_long ? *rc::gen::element<std::uint64_t>(0, second, 60 * second, 60 * second + 1, hour, hour + 1,
                                                      hour + 5 * second)
                   : *rc::gen::element<std::uint64_t>(0, 0, 1, 1000, 250000, 999999, second, second + 1);
}

/// Returns the mark of a log line. `is_marked` says whether the log has marks; rarely, a line differs from this.
std::string any_mark(bool is_marked) {
    const bool is_odd = *rc::gen::inRange(0, 20) == 0;
    return is_marked != is_odd ? *rc::gen::element<std::string>(" R", " R", " T") : "";
}

Scene any_scene() {
    Scene scene;
    const bool is_long = *rc::gen::inRange(0, 3) == 0;
    scene.period = *rc::gen::element<std::uint64_t>(0, is_long ? 1000 * second : 250000U);
    const bool is_marked = *rc::gen::arbitrary<bool>();
    const auto begin = *rc::gen::element<std::uint64_t>(0, 0, 1, is_long ? hour : 5U, is_long ? hour + 1 : 6U);
    std::uint64_t us = begin;
    scene.frames.resize(*rc::gen::inRange<std::size_t>(0, 20));
    std::string last;
    for (Line& line : scene.frames) {
        us += any_gap(is_long);
        const bool is_answer = last.rfind("300#", 0) == 0 && *rc::gen::arbitrary<bool>();
        last = is_answer ? "301" + last.substr(3)
                         : *rc::gen::element<std::string>("300#05", "300#05", "300#06", "300#06", "301#05", "301#06",
                                                          beat, "080#", "00000301#05", "301#R1", "301#0500");
        line.us = us;
        line.is_frame = true;
        line.text = last;
        line.mark = any_mark(is_marked);
        line.interface = *rc::gen::element<std::string>("vcan7", "vcan7", "can1");
    }
    us = begin;
    scene.stimuli.resize(*rc::gen::inRange<std::size_t>(0, 6));
    for (Line& line : scene.stimuli) {
        us += any_gap(is_long);
        line.us = us;
        line.text = *rc::gen::element<std::string>("one", "two");
        line.value = *rc::gen::element(0.0, 1.0, 2.5);
    }
    if (*rc::gen::inRange(0, 3) == 0) {
        scene.start = begin + any_gap(is_long);
    }
    if (*rc::gen::inRange(0, 3) == 0) {
        const std::uint64_t first = scene.frames.empty() ? 0U : scene.frames.front().us;
        scene.until = std::max(first, scene.start.value_or(0)) + any_gap(is_long);
    }
    return scene;
}

void check(const Scene& scene) {
    NaiveReplay naive{scene};
    naive.run();
    ReplayInput input;
    for (const Line& line : scene.frames) {
        input.frames.push_back(parse_candump_line(
            fmt::format("({}) {} {}{}", time_text(line.us), line.interface, line.text, line.mark), "law"));
    }
    for (const Line& line : scene.stimuli) {
        input.stimuli.push_back({"law", Instant{line.us}, line.text, line.value});
    }
    input.start = scene.start ? std::optional{Instant{*scene.start}} : std::nullopt;
    input.until = scene.until ? std::optional{Instant{*scene.until}} : std::nullopt;
    std::vector<std::string> notices;
    input.notice = [&](const std::string& text) { notices.push_back(text); };
    test::RecordingDevice device{Duration{scene.period}, beat};
    std::ostringstream frames;
    std::ostringstream outputs;
    replay(device, input, frames, &outputs);
    RC_ASSERT(device.told == naive.told);
    RC_ASSERT(outputs.str() == naive.outputs);
    RC_ASSERT(frames.str() == naive.frames);
    RC_ASSERT(notices == naive.notices);
}

}  // namespace

RC_GTEST_PROP(ReplayCallsLaw, ReplayMakesTheSameDeviceCallsAndOutputAsTheNaiveModel, ()) {
    for (int i = 0; i < 10; ++i) {
        check(any_scene());
    }
}

}  // namespace canproof::host
