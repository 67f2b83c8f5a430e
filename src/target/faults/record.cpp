// SPDX-License-Identifier: Apache-2.0
#include "target/faults/record.hpp"

#include <algorithm>

#include "target/faults/frame_kinds.hpp"
#include "target/faults/machine.hpp"
#include "target/faults/subject.hpp"

extern "C" {
extern std::uint8_t ram_begin[];
extern std::uint8_t ram_test_stack_begin[];
extern std::uint8_t stack_top[];
}

namespace canproof::faults {

namespace {

constexpr std::size_t most_passes = 32768;
constexpr std::size_t most_frames = 8192;
constexpr std::size_t most_frames_of_pass = 64;
constexpr std::size_t most_events = 512;
constexpr std::size_t most_outputs = 8192;

/// The data that the harness keeps from pass to pass.
struct Memory {
    std::uint32_t next_event;  ///< next event that may be a frame for the device
    std::uint32_t next_input;  ///< next event that may set the inputs
    std::uint32_t inputs;      ///< position of the event that set the present inputs
    std::uint32_t bit_rate;
};
struct RecordedPass {
    std::uint32_t ticks_before;  ///< ticks of all earlier passes, their waiting time included
    std::uint32_t ticks;         ///< ticks that the instructions of this pass take
    std::uint32_t sum;
    std::uint32_t first_frame;
    std::uint32_t outputs;  ///< position of the pass's outputs in the record
    std::uint32_t next_event;
    std::uint32_t bit_rate;
};

[[gnu::section(".bss.harness_record")]] const Event* events;
[[gnu::section(".bss.harness_record")]] std::uint32_t event_count;
[[gnu::section(".bss.harness_record")]] RawBytes inputs_of[most_events];
[[gnu::section(".bss.harness_record")]] RecordedPass passes[most_passes];
[[gnu::section(".bss.harness_record")]] Frame frames[most_frames];
[[gnu::section(".bss.harness_record")]] std::uint32_t frame_passes[most_frames];
[[gnu::section(".bss.harness_record")]] std::uint32_t frame_count;
[[gnu::section(".bss.harness_record")]] RawBytes outputs_list[most_outputs];
[[gnu::section(".bss.harness_record")]] std::uint32_t outputs_count;
[[gnu::section(".bss.harness_record")]] RawBytes output_mask;
[[gnu::section(".bss.harness_record")]] RawBytes safe_outputs;

Memory memory;
Frame sent[most_frames_of_pass];
std::uint32_t sent_count;
RawBytes driven;
std::uint32_t now_pass;
[[gnu::section(".bss.harness_record")]] std::uint32_t last_pass;
Differences seen;

std::uint8_t kept_ram[most_ram];  ///< all RAM of the device, with its stack and the words of the stack guard
std::uint32_t kept_sum;
Memory kept_memory;
std::uint32_t kept_pass;
stm32f405::CaptureRegisters capture;

bool same_outputs(const RawBytes& a, const RawBytes& b) {
    bool same = true;
    for (std::size_t i = 0; i < most_bytes; ++i) {
        same = same && ((a[i] ^ b[i]) & output_mask[i]) == 0;
    }
    return same;
}

void copy_bytes(std::uint8_t* to, const std::uint8_t* from, std::size_t count) {
    auto* const target = reinterpret_cast<volatile std::uint32_t*>(to);
    const auto* const source = reinterpret_cast<const volatile std::uint32_t*>(from);
    for (std::size_t i = 0; i < (count + 3U) / 4U; ++i) {
        target[i] = source[i];
    }
}

bool is_recorded_anywhere(const Frame& frame) {
    for (std::uint32_t i = 0; i < frame_count; ++i) {
        if (same_frame(frames[i], frame)) {
            return true;
        }
    }
    return false;
}

/// Returns whether this PDO equals the last recorded PDO with the same identifier up to `pass`, or the first one after
/// `pass`.
bool was_recorded_around(const Frame& frame, std::uint32_t pass) {
    const Frame* last = nullptr;
    for (std::uint32_t i = 0; i < frame_count; ++i) {
        if (frames[i].id != frame.id) {
            continue;
        }
        if (frame_passes[i] > pass) {
            return same_frame(frames[i], frame) || (last != nullptr && same_frame(*last, frame));
        }
        last = &frames[i];
    }
    return last != nullptr && same_frame(*last, frame);
}

void note(std::uint32_t effect, std::uint32_t pass) {
    seen.effects |= effect;
    if (seen.first_wrong == 0U && (effect & (Effect::wrong_output | Effect::wrong_pdo)) != 0U) {
        seen.first_wrong = pass;
    }
}

void note_additional(const Frame& frame, std::uint32_t pass) {
    if (is_emcy(frame)) {
        note(is_recorded_anywhere(frame) ? Effect::wrong_answer : Effect::emergency, pass);
    } else if (is_error_control(frame)) {
        note(Effect::network, pass);
    } else if (is_pdo(frame)) {
        note(was_recorded_around(frame, pass) ? Effect::missing_pdo : Effect::wrong_pdo, pass);
    } else {
        note(Effect::wrong_answer, pass);
    }
}

void note_missing(const Frame& frame, std::uint32_t pass) {
    if (is_error_control(frame)) {
        note(Effect::network, pass);
    } else {
        note(is_pdo(frame) ? Effect::missing_pdo : Effect::wrong_answer, pass);
    }
}

bool has(const Frame* list, std::uint32_t count, const Frame& frame) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (same_frame(list[i], frame)) {
            return true;
        }
    }
    return false;
}

void compare_frames(std::uint32_t pass) {
    const Frame* const expected = &frames[passes[pass].first_frame];
    const std::uint32_t count = passes[pass + 1U].first_frame - passes[pass].first_frame;
    for (std::uint32_t i = 0; i < sent_count; ++i) {
        if (!has(expected, count, sent[i])) {
            note_additional(sent[i], pass);
        }
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!has(&sent[0], sent_count, expected[i])) {
            note_missing(expected[i], pass);
        }
    }
}

std::uint32_t sum_of(const std::uint8_t* from, std::uint32_t bytes) {
    constexpr std::uint32_t factor = 0x01000193U;  // odd, so that no word is lost
    const auto* const words = reinterpret_cast<const volatile std::uint32_t*>(from);
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < bytes / 4U; ++i) {
        sum = sum * factor + words[i];
    }
    return sum;
}

std::uint32_t ram_sum() {
    return sum_of(ram_begin, variable_bytes());
}

std::uint32_t ram_bytes() {
    return stack_end() - ram_start();
}

void keep_state() {
    kept_memory = memory;
    copy_bytes(kept_ram, ram_begin, ram_bytes());
    kept_sum = sum_of(ram_begin, ram_bytes());
}

}  // namespace

std::uint32_t ram_start() {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(ram_begin));
}
std::uint32_t variable_bytes() {
    return static_cast<std::uint32_t>(ram_test_stack_begin - ram_begin);
}
std::uint32_t stack_end() {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(stack_top));
}

std::uint32_t region_of(std::uintptr_t address) {
    if (address >= ram_start() + variable_bytes()) {
        return 4;
    }
    std::uint32_t number = 0;
    for (const Area& area : subject().areas()) {
        const auto begin = reinterpret_cast<std::uintptr_t>(area.begin);
        if (address >= begin && address < begin + area.size) {
            return number;
        }
        ++number;
    }
    return 5;
}

void begin_record(const Event* all, std::uint32_t count) {
    events = all;
    event_count = count;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (events[i].is_frame == 0U) {
            subject().convert(events[i], inputs_of[i]);
        }
    }
    subject().mask_outputs(output_mask);
    constexpr std::uint32_t captured = 1U << 4U;
    capture.timer.status.write(captured);
}

/// Sets the inputs and the clock capture for a pass. If the workload sets inputs several times up to the time of the
/// pass, the last ones are used.
void begin_pass(std::uint32_t pass) {
    now_pass = pass;
    sent_count = 0;
    while (memory.next_input < event_count && events[memory.next_input].time_us <= pass * pass_us) {
        if (events[memory.next_input].is_frame == 0U) {
            memory.inputs = memory.next_input;
        }
        ++memory.next_input;
    }
    constexpr std::uint32_t ticks_of_capture = 84U * 250U;  // 8 periods of 32 kHz (250 µs), in ticks of 84 MHz
    capture.timer.compare[3].write(pass * ticks_of_capture);
}

void end_recorded_pass(std::uint32_t pass, std::uint32_t ticks) {
    if (outputs_count == 0U) {
        safe_outputs = driven;
    }
    if (pass + 2U > most_passes || frame_count + sent_count > most_frames || outputs_count == most_outputs) {
        say("broken: the record has no room for this workload\n");
        end_emulation();
    }
    if (outputs_count == 0U || !same_outputs(outputs_list[outputs_count - 1U], driven)) {
        outputs_list[outputs_count++] = driven;
    }
    last_pass = pass;
    passes[pass].outputs = outputs_count - 1U;
    passes[pass].sum = ram_sum();
    passes[pass].next_event = memory.next_event;
    passes[pass].bit_rate = memory.bit_rate;
    passes[pass].ticks = std::max<std::uint32_t>(ticks, 1);
    passes[pass + 1U].ticks_before = passes[pass].ticks_before + std::max<std::uint32_t>(ticks, ticks_of_pass);
    passes[pass + 1U].first_frame = frame_count + sent_count;
    for (std::uint32_t i = 0; i < sent_count; ++i) {
        frame_passes[frame_count] = pass;
        frames[frame_count++] = sent[i];
    }
    if (pass == 1U) {  // a fault can only begin after a complete pass
        kept_pass = 2U;
        keep_state();
    }
}

std::uint32_t ticks_before(std::uint32_t pass) {
    return passes[pass].ticks_before;
}
std::uint32_t ticks_into(std::uint32_t pass, std::uint32_t time) {
    return (time - passes[pass].ticks_before) % passes[pass].ticks;
}

std::uint32_t pass_at(std::uint32_t time) {
    std::uint32_t low = 2;
    std::uint32_t high = last_pass + 1U;
    while (low + 1U < high) {
        const std::uint32_t middle = (low + high) / 2U;
        (passes[middle].ticks_before <= time ? low : high) = middle;
    }
    return low;
}

namespace {

/// Ends the emulation when the state before `pass` is not that of the record. A device with a fault can have changed
/// the kept state.
void check_record(std::uint32_t pass) {
    if (!state_is_recorded(pass - 1U)) {
        say("broken: a run without a fault differs from the record\n");
        end_emulation();
    }
}

}  // namespace

void go_to(std::uint32_t pass, void (*do_pass)(std::uint32_t)) {
    copy_bytes(ram_begin, kept_ram, ram_bytes());
    memory = kept_memory;
    check_record(kept_pass);
    if (sum_of(ram_begin, ram_bytes()) != kept_sum) {
        say("broken: the kept state has changed\n");
        end_emulation();
    }
    if (kept_pass == pass) {
        return;
    }
    for (; kept_pass < pass; ++kept_pass) {
        do_pass(kept_pass);
    }
    check_record(pass);
    keep_state();
}

bool state_is_recorded(std::uint32_t pass) {
    return takes_interrupts() && memory.next_event == passes[pass].next_event &&
           memory.bit_rate == passes[pass].bit_rate && ram_sum() == passes[pass].sum;
}

void compare_pass(std::uint32_t pass) {
    compare_frames(pass);
    if (!same_outputs(driven, outputs_list[passes[pass].outputs])) {
        note(same_outputs(driven, safe_outputs) ? Effect::safe_output : Effect::wrong_output, pass);
    }
}

void clear_differences() {
    seen = Differences{};
}
const Differences& differences() {
    return seen;
}
bool is_silent(const Differences& all) {
    return (all.effects & (Effect::emergency | Effect::network)) == 0U &&
           (all.effects & (Effect::wrong_output | Effect::wrong_pdo)) != 0U;
}

Instant time_now() {
    return Instant{now_pass * pass_us};
}

/// Returns no frame while interrupts are masked: on the microcontroller an interrupt moves received frames to the ring
/// from which the device takes them.
bool take_frame(Frame& frame) {
    if (!takes_interrupts()) {
        return false;
    }
    while (memory.next_event < event_count && events[memory.next_event].time_us <= now_pass * pass_us) {
        const Event& event = events[memory.next_event++];
        if (event.is_frame != 0U) {
            frame = Frame{};
            frame.id = event.id;
            frame.length = static_cast<std::uint8_t>(event.length);
            for (std::size_t i = 0; i < max_frame_length; ++i) {
                frame.data[i] = event.data[i];
            }
            return true;
        }
    }
    return false;
}

void frame_sent(const Frame& frame) {
    if (sent_count < most_frames_of_pass) {
        sent[sent_count++] = frame;
    }
}

void outputs_driven(const void* outputs, std::size_t size) {
    const auto* const bytes = static_cast<const volatile std::uint8_t*>(outputs);
    for (std::size_t i = 0; i < size && i < most_bytes; ++i) {
        driven[i] = bytes[i];
    }
}

const RawBytes& present_inputs() {
    return inputs_of[memory.inputs];
}
void set_can_bit_rate(std::uint32_t rate) {
    memory.bit_rate = rate;
}
std::uint32_t can_bit_rate() {
    return memory.bit_rate;
}

stm32f405::CaptureRegisters& capture_registers() {
    return capture;
}

}  // namespace canproof::faults
