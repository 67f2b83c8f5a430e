#include "host/replay/replay.hpp"

#include <fmt/format.h>

#include "host/bus/echo_matcher.hpp"

namespace canproof::host {

namespace {

class Player {
  public:
    Player(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out)
        : device_{device},
          input_{input},
          interface_{input.frames.empty() ? "can0" : input.frames.front().interface},
          frames_out_{frames_out},
          outputs_out_{outputs_out} {
        if (outputs_out_ != nullptr) {
            *outputs_out_ << "seconds,signal,value\n";
        }
    }

    void run() {
        // Stimuli at 0 describe the world before power is switched on.
        while (next_stimulus_ < input_.stimuli.size() && input_.stimuli[next_stimulus_].time.us == 0) {
            stimulate(Instant{});
        }
        device_.power_on(Instant{});
        report(Instant{});
        for (Instant now = next(); now != never; now = next()) {
            step(now);
        }
    }

  private:
    Instant end() const {
        if (input_.until) {
            return *input_.until;
        }
        Instant last{};
        if (!input_.frames.empty()) {
            last = input_.frames.back().time;
        }
        if (!input_.stimuli.empty() && last < input_.stimuli.back().time) {
            last = input_.stimuli.back().time;
        }
        return last;
    }

    Instant next() const {
        Instant at = device_.next_deadline();
        if (next_frame_ < input_.frames.size()) {
            at = earliest(at, input_.frames[next_frame_].time);
        }
        if (next_stimulus_ < input_.stimuli.size()) {
            at = earliest(at, input_.stimuli[next_stimulus_].time);
        }
        return end() < at ? never : at;
    }

    void step(Instant now) {
        device_.advance(now);
        report(now);
        while (next_stimulus_ < input_.stimuli.size() && input_.stimuli[next_stimulus_].time <= now) {
            stimulate(now);
            report(now);
        }
        while (next_frame_ < input_.frames.size() && input_.frames[next_frame_].time <= now) {
            receive(input_.frames[next_frame_], now);
            ++next_frame_;
            report(now);
        }
    }

    /// A log of `run` marks what its devices sent: what this very device has said is not told to it.
    void receive(const LoggedFrame& logged, Instant now) {
        if (!logged.transmitted || !own_.match(logged.frame, false)) {
            device_.receive(logged.frame, now);
        }
    }

    void stimulate(Instant now) {
        const Stimulus& one = input_.stimuli[next_stimulus_];
        ++next_stimulus_;
        if (!device_.set_input(one.signal, one.value, now)) {
            throw InputError{fmt::format("stimulus at {} s: there is no input `{}`; `canproof signals` lists them",
                                         format_seconds(one.time), one.signal)};
        }
    }

    void report(Instant now) {
        while (!device_.queue().empty()) {
            const Frame frame = device_.queue().pop();
            own_.sent(frame, true);
            frames_out_ << format_candump_line({now, interface_, frame}) << '\n';
        }
        if (outputs_out_ == nullptr) {
            return;
        }
        const auto values = device_.outputs();
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (last_.empty() || last_[i] != values[i]) {
                *outputs_out_ << fmt::format("{},{},{:.6g}\n", format_seconds(now), device_.output_names()[i],
                                             values[i]);
            }
        }
        last_ = values;
    }

    SimulatedDevice& device_;
    const ReplayInput& input_;
    std::string interface_;
    std::ostream& frames_out_;
    std::ostream* outputs_out_;
    std::size_t next_frame_{0};
    std::size_t next_stimulus_{0};
    std::vector<double> last_;
    EchoMatcher<bool> own_;
};

}  // namespace

void replay(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out) {
    Player{device, input, frames_out, outputs_out}.run();
}

}  // namespace canproof::host
