// SPDX-License-Identifier: Apache-2.0
// Runs the workload once without a fault and records it. Then, for each fault, restores the state of the device before
// the pass of the main loop in which the fault occurs, and injects the fault. Compares each following pass with the
// record. A run ends when a self-test fails, the processor raises an exception, the state equals that of the record, or
// the workload ends.
#include "target/faults/campaign.hpp"

#include <algorithm>

#include "target/faults/dormant.hpp"
#include "target/faults/machine.hpp"
#include "target/faults/record.hpp"
#include "target/faults/watch.hpp"

namespace canproof::faults {

namespace {

/// The parameters of this run of the emulator. The script faults/run makes them, and QEMU's loader puts them into
/// memory.
struct Order {
    std::uint32_t passes;
    std::uint32_t with_tests;
    std::uint32_t events;
    std::uint32_t faults;
    std::uint32_t whole_runs;  ///< 1: every run goes to its end, also when dormant.hpp knows the rest
    std::uint32_t skip;        ///< how many faults to skip, because an earlier run of the emulator has judged them
};
enum class Kind : std::uint32_t { ram, core_register, program_counter, flash };
struct Fault {
    std::uint32_t time;  ///< time of the fault in ticks since power-on, added up over all passes; see ticks_before()
    Kind kind;
    std::uint32_t place;
    std::uint32_t bit;
};

const Order& order() {
    return *reinterpret_cast<const Order*>(order_address);
}
const Event* events() {
    return reinterpret_cast<const Event*>(events_address);
}
const Fault* faults() {
    return reinterpret_cast<const Fault*>(faults_address);
}

constexpr std::uint32_t most_further_passes = 50000;  ///< enough passes for two rounds of the tests of RAM and flash
/// The emulator spends more time on the start of a timer than on a pass, so one limit of ticks applies to many passes.
constexpr std::uint32_t passes_of_limit = 32;
/// ticks (5 million instructions) after which a run counts as hanging, if the limit has not been renewed before
constexpr std::uint32_t hangs_after = 4000000;
/// The same for the pass with the fault (312,500 instructions). Most runs that hang do so in this pass, and the
/// emulator needs seconds for a million instructions when a device executes data that it writes.
constexpr std::uint32_t hangs_at_once_after = 250000;
/// ticks that a device gets in addition when it masks interrupts
constexpr std::uint32_t masked_extra = 50000;
/// Ticks until the fault is tried again, if the timer interrupted the harness or a function that the harness called.
/// The handler of the timer takes fewer ticks, so that the harness goes on in between.
constexpr std::uint32_t retry_after = 64;

/// The run in progress. It is a global object, because no function returns after an exception of the processor.
struct Run {
    const Fault* fault;
    std::uint32_t pass;
    std::uint32_t fault_pass;
    std::uint32_t limited_from;  ///< pass in which the limit of ticks was renewed
    std::uint32_t region;
    std::uint32_t address;
    std::uint8_t* turned;      ///< a byte of flash with an inverted bit; nullptr when there is none
    std::uint32_t turned_bit;  ///< number of the inverted bit, in `turned` or in the byte of RAM at `address`
    bool injected;
    bool armed;
};
Run run;
std::uint32_t next_fault;
bool is_recording;

void turn_byte(std::uint8_t* at, std::uint32_t bit) {
    *at = static_cast<std::uint8_t>(*at ^ (1U << bit));
}

/// Inverts a bit of the RAM that the device uses at this moment: its variables, or its stack from `sp` on.
void turn_ram(std::uint32_t place, std::uint32_t bit, std::uint32_t sp) {
    const std::uint32_t variables = variable_bytes();
    const std::uint32_t on_stack = stack_end() - sp;
    const std::uint32_t at = place % (variables + on_stack);
    auto* const byte = reinterpret_cast<std::uint8_t*>(at < variables ? ram_start() + at : sp + (at - variables));
    run.address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(byte));
    run.region = region_of(run.address);
    run.turned_bit = bit & 7U;
    turn_byte(byte, run.turned_bit);
}

void turn_flash(std::uint32_t place, std::uint32_t bit) {
    run.turned = &flash_byte(place % flash_bytes());
    run.turned_bit = bit & 7U;
    run.address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(run.turned));
    turn_byte(run.turned, run.turned_bit);
    asm volatile("dsb\n isb" ::: "memory");
}

/// Inverts a bit of r0 to r12, lr, the flags N, Z, C, V and Q, or s0 to s31. The stack pointer gets no faults.
void turn_register(Interrupted& interrupted, bool has_floats, std::uint32_t place, std::uint32_t bit) {
    const std::uint32_t number = place % 47U;
    const std::uint32_t mask = 1U << (bit & 31U);
    run.region = number;
    run.address = interrupted.pc;
    if (number < 4U) {
        interrupted.r0_to_r3[number] ^= mask;
    } else if (number < 12U) {
        interrupted.r4_to_r11[number - 4U] ^= mask;
    } else if (number == 12U) {
        interrupted.r12 ^= mask;
    } else if (number == 13U) {
        interrupted.lr ^= mask;
    } else if (number == 14U) {
        interrupted.flags ^= 1U << (27U + ((bit & 31U) % 5U));
    } else {
        turn_float_register(interrupted, has_floats, number - 15U, bit & 31U);
    }
}

/// Inverts a bit of the program counter. If the new address is in neither flash nor RAM, the microcontroller raises an
/// exception. The emulated machine has other memory at some of these addresses. To get an exception there too, the
/// device continues at an address where that machine has no memory.
void turn_program_counter(Interrupted& interrupted, std::uint32_t bit) {
    constexpr std::uint32_t flash_end = 0x00100000U;  // 1 MiB
    constexpr std::uint32_t ram_end = 0x20020000U;    // 128 KiB
    constexpr std::uint32_t nothing = 0xF0000000U;
    const std::uint32_t pc = interrupted.pc ^ (1U << (1U + (bit % 31U)));  // bit 0 is no part of an address
    run.address = pc;
    const bool exists = pc < flash_end || (pc >= ram_start() && pc < ram_end);
    interrupted.pc = exists ? pc : nothing;
}

void inject(Interrupted& interrupted, bool has_floats) {
    const Fault& fault = *run.fault;
    run.injected = true;
    run.fault_pass = run.pass;
    const auto sp = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&interrupted.s0_to_s15[0])) +
                    (has_floats ? 72U : 0U);
    switch (fault.kind) {
        case Kind::ram:
            turn_ram(fault.place, fault.bit, sp);
            break;
        case Kind::core_register:
            turn_register(interrupted, has_floats, fault.place, fault.bit);
            break;
        case Kind::program_counter:
            turn_program_counter(interrupted, fault.bit);
            break;
        case Kind::flash:
        default:
            turn_flash(fault.place, fault.bit);
            break;
    }
}

void pass_of_device() {
    subject().pass();
}
void power_on_device() {
    subject().power_on(order().with_tests != 0U);
}

/// Ends the run as hanging after `ticks`, unless this function is called again before.
void limit(std::uint32_t ticks) {
    run.limited_from = run.pass;
    arm_timer(ticks);
    arm_watchdog(ticks + masked_extra);
}

/// Runs one pass. Injects the fault when it is due in this pass.
void do_pass() {
    begin_pass(run.pass);
    if (run.fault != nullptr && !run.injected && (run.armed || run.pass >= pass_at(run.fault->time))) {
        const bool is_late = run.armed || run.fault->time <= ticks_before(run.pass);
        arm_timer(is_late ? retry_after : ticks_into(run.pass, run.fault->time));
        run.armed = true;
    } else if (run.fault == nullptr) {
        start_measurement();
    } else if (run.pass == run.fault_pass + 1U || run.pass - run.limited_from >= passes_of_limit) {
        limit(hangs_after);
    }
    run_on_device_stack(pass_of_device);
}

void record_all() {
    is_recording = true;
    run = Run{};
    begin_record(events(), order().events);
    begin_pass(0);
    run_on_device_stack(power_on_device);
    for (run.pass = 1; run.pass <= order().passes; ++run.pass) {
        do_pass();
        end_recorded_pass(run.pass, measured_ticks());
    }
    is_recording = false;
    say("passes ");
    say_number(order().passes);
    say(" ticks ");
    say_number(ticks_before(run.pass));
    say(" ram ");
    say_number(variable_bytes());
    say(" flash ");
    say_number(flash_bytes());
    say(" failed ");
    say_number(subject().failed());
    say(" tested ");
    say_number(subject().tested());
    for (const Area& area : subject().areas()) {
        say(" area ");
        say_number(static_cast<std::uint32_t>(area.size));
    }
    say("\n");
}

/// Writes the result of the present run: number of the fault, kind, region, pass of the fault, end of the run, and pass
/// of the end. Then writes the pass of the first wrong value, the effects and the address. The end of the run is a
/// number of SelfTest or of End.
void report(End end) {
    stop_timer();
    stop_watchdog();
    end_watch();
    if (run.turned != nullptr) {
        turn_byte(run.turned, run.turned_bit);
        run.turned = nullptr;
        asm volatile("dsb\n isb" ::: "memory");
    }
    const Differences& seen = differences();
    const std::uint32_t numbers[] = {next_fault,
                                     static_cast<std::uint32_t>(run.fault->kind),
                                     run.region,
                                     run.fault_pass,
                                     static_cast<std::uint32_t>(end),
                                     run.pass,
                                     seen.first_wrong,
                                     seen.effects,
                                     run.address};
    say("fault");
    for (const std::uint32_t number : numbers) {
        say(" ");
        say_number(number);
    }
    say("\n");
    ++next_fault;
}

/// Returns whether the state of the device is compared with the record after this pass. The comparisons are frequent at
/// first, because most faulty states soon equal the record again.
bool compares_state() {
    const std::uint32_t since = run.pass - run.fault_pass;
    return run.injected && run.fault->kind != Kind::flash && ((since & (since - 1U)) == 0U || (since % 32U) == 0U);
}

/// Returns whether the rest of the workload equals the record. A silent fault goes on until the self-tests have looked
/// at it; see run_tests().
bool rest_is_known() {
    return run.fault->kind == Kind::ram && order().whole_runs == 0U && !is_silent(differences()) &&
           is_dormant(run.address, run.turned_bit, run.pass);
}

/// Returns the number of the self-test that failed, or `unknown` when a device with a fault has stopped with another
/// number; 0 when none failed, or without self-tests.
std::uint32_t failed_test() {
    constexpr std::uint32_t unknown = 9;
    return order().with_tests == 0U ? 0U : std::min(subject().failed(), unknown);
}

End run_to_end() {
    for (; run.pass <= order().passes; ++run.pass) {
        do_pass();
        if (const std::uint32_t failed = failed_test(); failed != 0U) {
            return static_cast<End>(failed);
        }
        compare_pass(run.pass);
        if (is_unused() || !compares_state()) {
            continue;
        }
        if (state_is_recorded(run.pass)) {
            return End::equal;
        }
        if (rest_is_known()) {
            run.pass = order().passes + 1U;
            return End::workload;
        }
    }
    end_dormancy();
    return End::workload;
}

/// After the workload, waits for the tests of RAM and flash, which need more passes than the workload has.
End run_tests() {
    const std::uint32_t wanted = subject().tested() + 2U;
    for (std::uint32_t i = 0; i < most_further_passes && subject().tested() < wanted; ++i, ++run.pass) {
        do_pass();
        if (const std::uint32_t failed = failed_test(); failed != 0U) {
            return static_cast<End>(failed);
        }
    }
    return End::workload;
}

[[noreturn]] void campaign() {
    while (next_fault < order().faults) {
        const Fault& fault = faults()[next_fault];
        const std::uint32_t pass = pass_at(fault.time);
        run = Run{};
        unmask_interrupts();
        restore_system_registers();
        protect_harness();
        restore_flash();
        go_to(pass, [](std::uint32_t number) {
            run.pass = number;
            do_pass();
        });
        run.pass = pass;
        run.fault = &fault;
        clear_differences();
        End end = run_to_end();
        if (end == End::workload && order().with_tests != 0U && is_silent(differences())) {
            end = run_tests();
        }
        if (!run.injected) {
            if (pass < order().passes) {
                say("broken: a run ends without its fault\n");
                end_emulation();
            }
            run.fault_pass = pass;  // the fault was due only after the last instruction of the workload
        }
        report(end);
    }
    say("end\n");
    end_emulation();
}

}  // namespace

bool timer_fired(Interrupted& interrupted, bool has_floats) {
    stop_timer();
    if (run.injected) {
        return false;
    }
    const auto stack = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&interrupted));
    if (interrupted.pc >= harness_start || stack >= harness_start) {  // the harness also calls the device's functions
        arm_timer(retry_after);
        return true;
    }
    inject(interrupted, has_floats);
    limit(hangs_at_once_after);
    return true;
}

void resume(bool was_exception) {
    if (is_recording || run.fault == nullptr || !run.injected) {
        say(was_exception ? "broken: exception without a fault\n" : "broken: a run without a fault hangs\n");
        end_emulation();
    }
    report(was_exception ? End::exception : End::hangs);
    campaign();
}

void start_campaign() {
    next_fault = order().skip;
    keep_flash();
    record_all();
    load_dormancy();
    campaign();
}

}  // namespace canproof::faults
