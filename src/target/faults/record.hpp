// SPDX-License-Identifier: Apache-2.0
// The record of the run without a fault, and the comparison of a run with it.
#pragma once

#include "target/faults/campaign.hpp"

namespace canproof::faults {

/// Addresses of the input, at which the script `run` loads it. More than one bit differs from any address of the
/// device.
constexpr std::uintptr_t order_address = 0x21180000U;
constexpr std::uintptr_t events_address = 0x21180100U;
constexpr std::uintptr_t unused_address = 0x21280000U;
constexpr std::uintptr_t faults_address = 0x21300000U;
constexpr std::uintptr_t harness_start = 0x21000000U;

constexpr std::size_t most_ram = 32768;  ///< size of the device's RAM

/// Ticks of a pass of 100 µs, on a core of 168 MHz with 1.5 cycles per instruction, as in run_suites, and 1.25
/// instructions per tick.
constexpr std::uint32_t ticks_of_pass = 8960;

/// How a run ended. A number below 16 is that of the self-test that failed (SelfTest).
enum class End : std::uint32_t { equal = 16, workload, exception, hangs };

/// Differences from the record, as bits: the same kinds as in host/assess/inject/fault_effect.hpp.
struct Effect {
    static constexpr std::uint32_t emergency = 1U;
    static constexpr std::uint32_t network = 2U;
    static constexpr std::uint32_t safe_output = 4U;
    static constexpr std::uint32_t wrong_output = 8U;
    static constexpr std::uint32_t wrong_pdo = 16U;
    static constexpr std::uint32_t missing_pdo = 32U;
    static constexpr std::uint32_t wrong_answer = 64U;
};
struct Differences {
    std::uint32_t effects;
    std::uint32_t first_wrong;  ///< pass of the first wrong output or PDO; 0 when there is none
};

/// Prepares the events, and the record of a new run.
void begin_record(const Event* events, std::uint32_t count);
/// Sets time, inputs and bus for a pass.
void begin_pass(std::uint32_t pass);
void end_recorded_pass(std::uint32_t pass, std::uint32_t ticks);
/// Returns the ticks of all passes before `pass`. A pass takes 0.1 ms, or longer if its instructions need more time.
std::uint32_t ticks_before(std::uint32_t pass);
/// Returns the ticks from the start of `pass` to a fault at `time`. If the instructions of the pass end before `time`,
/// the fault occurs in a repetition of the pass, because the main loop of a microcontroller repeats it for the rest of
/// the 0.1 ms.
std::uint32_t ticks_into(std::uint32_t pass, std::uint32_t time);
/// Returns the pass during which the ticks of all passes reach `time`.
std::uint32_t pass_at(std::uint32_t time);

/// Returns the size of the device's flash: vectors and image.
std::uint32_t flash_bytes();
std::uint8_t& flash_byte(std::uint32_t at);
/// Copies the flash (keep_flash), and restores the flash from this copy (restore_flash). A store to a wrong address by
/// a device with a fault changes the emulated flash; it would not change the flash of the microcontroller.
void keep_flash();
void restore_flash();

/// Restores the recorded state before `pass`, which must not be smaller than in the previous call. `do_pass` runs one
/// pass.
void go_to(std::uint32_t pass, void (*do_pass)(std::uint32_t));
/// Returns whether the variables have the contents that were recorded after `pass`, the device takes interrupts, and it
/// has taken as many frames and set the same bit rate as recorded.
bool state_is_recorded(std::uint32_t pass);
void compare_pass(std::uint32_t pass);
void clear_differences();
const Differences& differences();
/// Returns whether the fault was silent: an output or PDO had a wrong value, but no EMCY, boot-up or heartbeat message
/// differed from the run without the fault.
bool is_silent(const Differences& seen);

std::uint32_t ram_start();
std::uint32_t variable_bytes();
std::uint32_t stack_end();
/// Returns the number of the part of the RAM in which `address` is: 0 device, 1 queue, 2 parameter memory, 3 main loop
/// and self-tests, 4 stack, 5 other.
std::uint32_t region_of(std::uintptr_t address);

}  // namespace canproof::faults
