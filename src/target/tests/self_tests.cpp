// SPDX-License-Identifier: Apache-2.0
// Runs the self-tests of a flashed device on QEMU's processor, flash and RAM, with the device's linker script. Prints
// whether each test succeeds and how many instructions a pass of the main loop spends on it, for run_self_tests. QEMU's
// TIM5 captures nothing, so the check of the clock is not here.
#include "target/stm32f405/selftest/self_tests.hpp"

#include "devices/ax060805/firmware/ax060805.hpp"
#include "devices/ax130751/firmware/ax130751.hpp"
#include "devices/ax188001/firmware/ax188001.hpp"
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "generated/ax130751/signals.hpp"
#include "instruction_clock.hpp"
#include "target/image/image.hpp"
#include "target/semihost.hpp"
#include "target/stm32f405/image_check.hpp"
#include "target/stm32f405/selftest/core.hpp"
#include "target/stm32f405/selftest/output_copy.hpp"
#include "target/stm32f405/selftest/settings_guard.hpp"
#include "target/stm32f405/selftest/state_guard.hpp"

namespace {

using namespace canproof;
using namespace canproof::stm32f405;

constexpr int sys_write0 = 0x04;
constexpr int sys_exit_extended = 0x20;

/// Variables with known contents, in the middle of the RAM that is tested.
std::array<std::uint32_t, 2048> content;

/// Memory of the size of an `Object`: here of the largest device and of a transmit queue.
template <typename Object>
struct alignas(Object) SameSize {
    std::array<std::uint8_t, sizeof(Object)> bytes;
};
SameSize<ax130751::Device> device_memory;
SameSize<TransmitQueue> queue_memory;

void say(const char* text) {
    target::semihost(sys_write0, text);
}

/// Prints a line `NAME ok INSTRUCTIONS`, or `NAME failed INSTRUCTIONS`. For flash_crc and state_changed the number is
/// the number of checked bytes.
void say(const char* name, bool ok, std::uint32_t instructions) {
    std::array<char, 12> digits{};
    std::size_t first = digits.size() - 1;
    do {
        digits[--first] = static_cast<char>('0' + (instructions % 10));
        instructions /= 10;
    } while (instructions != 0);
    say(name);
    say(ok ? " ok " : " failed ");
    say(&digits[first]);
    say("\n");
}

/// Runs `steps` steps. Prints whether all of them succeeded, and how many instructions the longest step took.
template <typename Step>
void measure(const char* name, std::uint32_t steps, const Step& step) {
    const target::InstructionClock clock;
    bool ok = true;
    std::uint32_t most = 0;
    for (std::uint32_t i = 0; i < steps; ++i) {
        clock.start();
        ok = step() && ok;
        most = std::max(most, clock.instructions());
    }
    say(name, ok, most);
}

/// Measures the checksum over a state as large as a `Device`: keeps it once and compares it once.
template <typename Device>
void measure_state(const char* name) {
    StateGuard state{ByteView{device_memory.bytes}.part(0, sizeof(Device))};
    measure(name, 1, [&state] {
        state.keep();
        return state.matches();
    });
}

/// Measures the checksum over as many settings as the dictionary `tables` has.
template <const DictionaryTables& tables>
void measure_settings(const char* name) {
    static PdoMemoryFor<tables> pdos;
    const PdoMemory all = pdos.memory();
    const std::size_t size = tables.defaults.count - tables.settings_at;
    const NodeSettings settings{
        0, ByteView{device_memory.bytes}.part(0, size), all.received, all.sent, all.received_lines, all.sent_lines};
    SettingsGuard guard;
    guard.keep(settings);
    measure(name, 1, [&] { return guard.follow(settings); });
}

/// Returns whether the checksum notices a changed bit of each byte, and matches when no bit has changed.
bool notices_each_byte() {
    StateGuard state{object_bytes(device_memory)};
    state.keep();
    bool ok = true;
    for (std::uint8_t& byte : device_memory.bytes) {
        byte = 0x10;
        ok = !state.matches() && ok;
        byte = 0;
    }
    return state.matches() && ok;
}

bool keeps_content(RamCheck& ram) {
    for (std::uint32_t i = 0; i < content.size(); ++i) {
        content[i] = i * 0x9E3779B9U;
    }
    bool ok = true;
    for (std::uint32_t pass = 0; pass < RamCheck::background_count; ++pass) {
        ok = ram.pass() && ok;
    }
    for (std::uint32_t i = 0; i < content.size(); ++i) {
        ok = (content[i] == i * 0x9E3779B9U) && ok;
    }
    return ok;
}

}  // namespace

extern "C" void can_received() {}

/// The last test: the image must come here because of the exception at the end of image_main().
extern "C" void device_failed() {
    say("exception", true, 0);
    const std::array<std::uint32_t, 2> exit{0x20026U, 0};
    target::semihost(sys_exit_extended, &exit);
}

extern "C" void image_main() {
    const ImageMemory memory = target::image_memory();
    measure("core", 1, core_registers_hold);

    StackGuard guard{memory.stack_guard};
    guard.start();
    measure("stack", 1, [&guard] { return guard.is_intact(); });

    RamCheck ram{memory.ram};
    const auto slices = static_cast<std::uint32_t>(memory.ram.words.size() / (ram_slice - 1));
    measure("ram", slices, [&ram] { return ram.step(); });
    measure("ram_content", 1, [&ram] { return keeps_content(ram); });

    FlashCheck flash{memory.vectors, memory.flash};
    const auto size = memory.vectors.size() + memory.flash.size();
    measure("flash", static_cast<std::uint32_t>(size / FlashCheck::slice + 2), [&flash] { return flash.step(); });
    say("flash_crc", flash.passes() == 1, static_cast<std::uint32_t>(size));

    // The AX130751 has the most outputs. A pass keeps their copy once and compares it twice.
    const generated::ax130751::Outputs outputs{};
    OutputCopy<generated::ax130751::Outputs> copy;
    measure("outputs", 1, [&] {
        copy.keep(outputs);
        return copy.matches(outputs) && copy.matches(outputs);
    });

    measure_state<ax060805::Device>("state_ax060805");
    measure_state<ax130751::Device>("state_ax130751");
    measure_state<ax188001::Device>("state_ax188001");
    measure_state<cbx_ao412::Device>("state_cbx_ao412");
    measure_settings<generated::ax060805::compiled::tables>("settings_ax060805");
    measure_settings<generated::ax130751::compiled::tables>("settings_ax130751");
    measure_settings<generated::ax188001::compiled::tables>("settings_ax188001");
    measure_settings<generated::cbx_ao412::compiled::tables>("settings_cbx_ao412");
    say("state_changed", notices_each_byte(), sizeof device_memory);
    StateGuard queue{object_bytes(queue_memory)};
    measure("queue", 1, [&queue] {
        queue.keep();
        return queue.matches();
    });

    // Measures all self-tests of a pass except those of the outputs. Time stands still, because QEMU's timer captures
    // nothing.
    SelfTests tests{memory, registers_at<CaptureRegisters>(tim5_address), 84};
    const Instant now{};
    const bool starts = tests.start(now) == SelfTest::none;
    measure("pass", 3 * slices, [&] { return starts && tests.step(now) == SelfTest::none; });

    FailureRecord record{target::failure_words()};
    record.keep(SelfTest::ram);
    measure("record", 1, [&record] { return record.take() == SelfTest::ram && record.take() == SelfTest::none; });

    asm volatile("udf #0");
}
