// SPDX-License-Identifier: Apache-2.0
// Compares the calls and the output of a replay with those of a naive replay, which goes through one list of lines.
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

/// A line of the log or of the stimuli.
struct Line {
    std::uint64_t us{0};
    bool is_frame{false};
    std::string text;  ///< the frame, or the name of the input
    double value{0.0};
    std::string mark;
};

struct Scene {
    std::vector<Line> frames;
    std::vector<Line> stimuli;
    std::uint64_t period{0};  ///< of the device's own work; 0: it has none
    std::optional<std::uint64_t> start;
    std::optional<std::uint64_t> until;
};

/// A device that answers 300h with 301h and sends a frame in each period, replayed line by line.
class NaiveReplay {
  public:
    explicit NaiveReplay(const Scene& scene) : scene_{scene} {}

    void run() {
        const bool is_late = !scene_.frames.empty() && scene_.frames.front().us > hour;
        const std::uint64_t start = scene_.start.value_or(is_late ? scene_.frames.front().us : 0U);
        is_marked_ = !scene_.frames.empty() && !scene_.frames.front().mark.empty();
        shift_ = start;
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
            }
        }
        work_until(scene_.until ? *scene_.until - std::min(shift_, *scene_.until) : last_);
        for (const auto& [us, frame] : held_) {
            write(us, frame);
        }
    }

    std::vector<std::string> told;
    std::string frames;
    std::string outputs;

  private:
    /// Returns the frames from the start on and the stimuli after it; of equal times, the stimuli come first.
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
    void play(const Line& line) {
        const std::uint64_t due = std::min(line.us - shift_, last_ + hour);
        work_until(due);
        now_ = std::max(now_, due);
        shift_ = std::max(shift_, line.us - now_);
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
    /// Takes the oldest equal frame of the last minute.
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
        frames += fmt::format("({}) vcan7 {}\n", time_text(us), frame);
    }

    const Scene& scene_;
    bool is_marked_{false};
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

Scene any_scene() {
    Scene scene;
    const bool is_long = *rc::gen::inRange(0, 3) == 0;
    scene.period = *rc::gen::element<std::uint64_t>(0, is_long ? 1000 * second : 250000U);
    const bool is_marked = *rc::gen::arbitrary<bool>();
    const auto begin = *rc::gen::element<std::uint64_t>(0, 0, 1, is_long ? hour : 5U, is_long ? hour + 1 : 6U);
    std::uint64_t us = begin;
    scene.frames.resize(*rc::gen::inRange<std::size_t>(0, 20));
    for (Line& line : scene.frames) {
        us += any_gap(is_long);
        const auto mark = is_marked ? *rc::gen::element<std::string>(" R", " T") : std::string{};
        line = {us, true,
                *rc::gen::element<std::string>("300#05", "300#05", "300#06", "301#05", "301#05", "301#06", "705#7F",
                                               "080#", "00000301#05", "301#R1", "301#0500"),
                0.0, mark};
    }
    us = begin;
    scene.stimuli.resize(*rc::gen::inRange<std::size_t>(0, 6));
    for (Line& line : scene.stimuli) {
        us += any_gap(is_long);
        line = {us, false, *rc::gen::element<std::string>("one", "two"), *rc::gen::element(0.0, 1.0, 2.5), ""};
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

}  // namespace

RC_GTEST_PROP(ReplayCallsLaw, ReplayMakesTheCallsOfTheNaiveReplayAndWritesTheSame, ()) {
    const Scene scene = any_scene();
    NaiveReplay naive{scene};
    naive.run();
    ReplayInput input;
    for (const Line& line : scene.frames) {
        input.frames.push_back(
            parse_candump_line(fmt::format("({}) vcan7 {}{}", time_text(line.us), line.text, line.mark), "law"));
    }
    for (const Line& line : scene.stimuli) {
        input.stimuli.push_back({"law", Instant{line.us}, line.text, line.value});
    }
    input.start = scene.start ? std::optional{Instant{*scene.start}} : std::nullopt;
    input.until = scene.until ? std::optional{Instant{*scene.until}} : std::nullopt;
    test::RecordingDevice device{Duration{scene.period}, beat};
    std::ostringstream frames;
    std::ostringstream outputs;
    replay(device, input, frames, &outputs);
    RC_ASSERT(device.told == naive.told);
    RC_ASSERT(outputs.str() == naive.outputs);
    std::string expected = naive.frames;
    if (scene.frames.empty()) {  // without a log, the interface has its usual name
        for (auto at = expected.find("vcan7"); at != std::string::npos; at = expected.find("vcan7")) {
            expected.replace(at, 5, "can0");
        }
    }
    RC_ASSERT(frames.str() == expected);
}

}  // namespace canproof::host
