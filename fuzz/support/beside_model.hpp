// SPDX-License-Identifier: Apache-2.0
// Runs the events of an input (device_world.hpp) on a device and on the naive model of the whole device, and compares
// the two after each event and at each deadline of the device. A model knows only some requests, and neither a late
// driver nor a failing memory. So, in a run beside a model, records of these kinds (device_world.hpp) stand for other
// events:
//   0…3, 5, F  a write of a parameter that the model knows, or a frame that it knows, if it does not know the request
//   B          an input value that the model knows, if it does not know the value of the record
//   C          time during which the driver keeps every deadline, less than Model::longest_wait_ms
//   D          a power cut after the frame was served
// After the events of the input, Model::further_events random events follow. The first record determines these events
// and the choices of begin(). A frame that the model does not know is given neither to the device nor to the model;
// model_counts.hpp counts these frames by reason.
//
// The constructor of a `Model` gets the device, whose address stays the same. A `Model` has:
//   power_on(inputs, ms) · set_inputs(inputs) · receive(frame) · pass(ms)
//   unknown(frame, device), unknown(inputs)  why the model does not know it, or nullptr
//   usual_frame(node, which, data)           a frame that it knows
//   ends()                                   why the model cannot go on, or nullptr
//   compare(device, said, ms)                requires that device and model show the same and have sent the same frames
//   put_usual_input(inputs, which, data)     changes an input to a value that it knows
//   begin(run, choices)                      may give device and model some events before those of the input
//   finish(device)                           may compare more at the end of the input
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/support/fuzz_device.hpp"
#include "fuzz/support/known_parameters.hpp"
#include "fuzz/support/model_counts.hpp"
#include "fuzz/support/read_sample.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::fuzz {

/// Returns whether a physical input is a usual number in this range; not a subnormal one, and not -0.
inline bool is_usual(float value, float low, float high) {
    return value >= low && value <= high && (std::isnormal(value) || (value == 0.0F && !std::signbit(value)));
}

/// Pseudo-random choices that follow from a seed.
class Choices {
  public:
    explicit Choices(std::uint64_t seed) : state_{seed} {}
    unsigned below(unsigned count) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<unsigned>(state_ >> 33U) % count;
    }
    template <std::size_t Count>
    unsigned one_of(const std::array<unsigned, Count>& values) {
        return values[below(Count)];
    }

  private:
    std::uint64_t state_;
};

/// The frames of one moment, each with its time in ms and its text.
using TimedFrames = std::vector<std::pair<std::uint64_t, std::string>>;

/// Returns the frames of one moment as TimedFrames.
inline TimedFrames timed(const std::vector<Frame>& frames, std::uint64_t ms) {
    TimedFrames all;
    for (const Frame& frame : frames) {
        all.emplace_back(ms, host::format_frame(frame));
    }
    return all;
}

/// Returns the reason why the models of the Axiomatic devices need not know a frame: another fuzz target compares
/// remote frames and frames of LSS. Returns nullptr for other frames. The frame must have an 11-bit identifier.
inline const char* compared_elsewhere(const Frame& frame) {
    if (frame.remote) {
        return "pdo and error_control compare remote frames";
    }
    return frame.id == 0x7E5 ? "lss compares LSS" : nullptr;
}

/// Ends the run as a finding if `holds` is false: a value of the device differs from that of the model.
inline void check_model(bool holds, const char* what, unsigned index) {
    require(holds, what, index);
}

/// Requires that the device has sent the frames of the model (`expected`). Prints both lists when they differ.
inline void require_frames(const TimedFrames& said, const TimedFrames& expected, const char* file = __builtin_FILE(),
                           int line = __builtin_LINE()) {
    if (said == expected) {
        return;
    }
    for (const auto& [ms, text] : said) {
        std::fprintf(stderr, "device: %llu ms %s\n", static_cast<unsigned long long>(ms), text.c_str());
    }
    for (const auto& [ms, text] : expected) {
        std::fprintf(stderr, "model:  %llu ms %s\n", static_cast<unsigned long long>(ms), text.c_str());
    }
    require(false, "the frames of the model", 0, file, line);
}

template <typename Unit, typename Model>
class BesideModel {
  public:
    using Inputs = typename Unit::Inputs;

    /// Begins with a device that has just been switched on.
    BesideModel(DeviceWorld<Unit>& world, std::uint64_t seed) : world_{world}, choices_{seed}, model_{world.device()} {
        model_.power_on(world_.inputs(), now_ms());
        compare();
        model_.begin(*this, choices_);
        parameters_ = &known_parameters();
    }
    void run(const std::uint8_t* data, std::size_t size) {
        end_ms_ = now_ms() + Model::longest_run_ms;
        const std::size_t count = std::min(size / device_record_size, most_device_records);
        for (std::size_t i = 0; i < count && goes_on(); ++i) {
            happen(data + i * device_record_size);
        }
        for (unsigned i = 0; i < Model::further_events && goes_on(); ++i) {
            happen(further_record().data());
        }
        if (const char* const why = model_.ends()) {
            ++model_counts.ended[why];
            return;
        }
        pass(5);
        model_.finish(world_.device());
    }

    void receive(const Frame& frame) {
        if (const char* const why = model_.unknown(frame, world_.device())) {
            return leave_out(why);
        }
        world_.receive(frame);
        model_.receive(frame);
        happened();
    }
    void pass(std::uint64_t ms) {
        const Instant end = world_.now() + milliseconds(ms);
        while (world_.now() < end) {
            const std::uint64_t before = now_ms();
            world_.run_until(earliest(world_.next_deadline(), end));
            model_.pass(now_ms() - before);
            compare();
        }
    }

  private:
    bool goes_on() const { return now_ms() < end_ms_ && model_.ends() == nullptr; }
    void happen(const std::uint8_t* record) {
        switch (record[0] & 0x0FU) {
            case 0xB:
                return set_input(record);
            case 0xC:
                return pass(duration_in(record).us / 1000U % Model::longest_wait_ms);
            case 0xD:
                receive(known_frame(record, (record[1] & 1U) != 0 ? 5 : 0));
                return power_cycle(record);
            case 0xE:
                return power_cycle(record);
            case 0xF:
                return receive(known_frame(record, 0));
            case 4:
            case 6:
            case 7:
            case 8:
            case 9:
            case 0xA:
                if (const std::optional<Frame> frame = world_.frame_in(record)) {
                    receive(*frame);
                }
                return;
            default:
                return receive(known_frame(record, record[0]));
        }
    }
    using Record = std::array<std::uint8_t, device_record_size>;
    static Record with_kind(const std::uint8_t* record, unsigned kind) {
        Record other{};
        std::copy_n(record, other.size(), other.begin());
        other[0] = static_cast<std::uint8_t>(kind);
        return other;
    }
    /// Returns a random record for an event after those of the input: a frame, a write of a parameter, a change of an
    /// input, or time that passes.
    Record further_record() {
        constexpr std::array<unsigned, 8> kinds{0xF, 0xF, 0xF, 0xF, 0xB, 0xB, 0xC, 0xC};
        Record record{};
        for (std::uint8_t& byte : record) {
            byte = static_cast<std::uint8_t>(choices_.below(256));
        }
        record[0] = static_cast<std::uint8_t>(choices_.one_of(kinds));
        return record;
    }
    /// Returns the frame that the record describes when read as a record of `kind`, if the model knows this frame;
    /// otherwise another frame that the model knows.
    Frame known_frame(const std::uint8_t* record, unsigned kind) const {
        const Frame frame = *world_.frame_in(with_kind(record, kind).data());
        const std::uint8_t* const data = record + 2;
        const bool is_known = (kind & 0x0FU) != 5U && model_.unknown(frame, world_.device()) == nullptr;
        if (is_known) {
            return frame;
        }
        return (data[9] & 1U) != 0 ? model_.usual_frame(node(), data[8], data) : parameters_->write(node(), data);
    }
    unsigned node() const { return world_.device().node_id(); }
    void set_input(const std::uint8_t* record) {
        Inputs next = world_.inputs();
        put_input(next, record[1], record + 2);
        if (model_.unknown(next) != nullptr) {
            next = world_.inputs();
            Model::put_usual_input(next, record[1], record + 2);
        }
        world_.set_inputs(next);
        model_.set_inputs(next);
        happened();
    }
    void power_cycle(const std::uint8_t* record) {
        world_.befall(with_kind(record, 0xE).data());
        model_.power_on(world_.inputs(), now_ms());
        happened();
    }
    void happened() {
        ++model_counts.events;
        compare();
    }
    void compare() { model_.compare(world_.device(), world_.take_sent(), now_ms()); }
    static void leave_out(const char* why) { ++model_counts.left_out[why]; }
    std::uint64_t now_ms() const { return world_.now().us / 1000U; }

    /// Returns the parameters that the model knows. They are determined once, because they are the same for each fuzz
    /// input.
    const KnownParameters& known_parameters() const {
        const auto is_known = [this](const Frame& write) { return model_.unknown(write, world_.device()) == nullptr; };
        static const KnownParameters known{world_.device().objects(), is_known, node()};
        return known;
    }

    DeviceWorld<Unit>& world_;
    Choices choices_;
    std::uint64_t end_ms_{0};
    Model model_;
    const KnownParameters* parameters_{nullptr};
};

/// The circumstances of each run beside a model. The start time is a multiple of the period of each LED pattern. It is
/// not 0: only runs that start at 0 log their frames (device_world.hpp), and each frame must be logged once.
constexpr Circumstances beside_a_model{24'000'000U, 0U};

/// Runs one input on the device and on its naive model. Uses the device of the previous input again, as it was after
/// power-on.
template <typename Unit, typename Model>
void run_beside_model(const std::uint8_t* data, std::size_t size) {
    static Reused<DeviceWorld<Unit>> world{beside_a_model};
    Digest digest;
    digest.add(ByteView{data, std::min(size, device_record_size)});
    BesideModel<Unit, Model>{world.at_start(), digest.value()}.run(data, size);
}

/// Makes one of `samples.compared_one_in` inputs also run beside the naive model of the device. The environment
/// variables CANPROOF_COMPARED_ONE_IN and CANPROOF_REPEATED_ONE_IN set the numbers of `samples`.
inline bool set_beside_model(void (*run)(const std::uint8_t*, std::size_t)) {
    beside_model = run;
    read_sample("CANPROOF_COMPARED_ONE_IN", samples.compared_one_in);
    read_sample("CANPROOF_REPEATED_ONE_IN", samples.repeated_one_in);
    return true;
}

}  // namespace canproof::fuzz
