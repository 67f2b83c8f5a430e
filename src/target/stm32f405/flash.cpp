// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/flash.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// These two keys in this order unlock FLASH_CR; any other write locks it until the next reset (RM0090 3.6.1).
constexpr std::uint32_t first_key = 0x45670123U;
constexpr std::uint32_t second_key = 0xCDEF89ABU;

}  // namespace

void Flash::begin() noexcept {
    registers_.access_control.clear(flash_acr::data);
    if (registers_.control.has(flash_cr::lock)) {
        registers_.key.write(first_key);
        registers_.key.write(second_key);
    }
}

/// Locks the flash, clears the data cache, which may hold old words, and switches the cache on again. The cache must
/// be off while it is cleared (RM0090 3.5.2). A busy flash is not locked: see end_operation().
void Flash::finish() noexcept {
    if (wait()) {
        registers_.control.write(flash_cr::lock);
    }
    registers_.access_control.set(flash_acr::reset_data);
    registers_.access_control.clear(flash_acr::reset_data);
    registers_.access_control.set(flash_acr::data);
}

static_assert(implements<req::CO_FLASH_004>);
bool Flash::wait() const noexcept {
    for (std::uint32_t poll = 0U; poll < most_polls_; ++poll) {
        if (!registers_.status.has(flash_sr::busy)) {
            return true;
        }
    }
    return false;
}

/// Waits for the last operation and clears its errors, which would block the next one (RM0090 3.6.4). Returns false
/// when the operation does not end.
bool Flash::is_ready() noexcept {
    const bool is_idle = wait();
    if (is_idle) {
        registers_.status.write(flash_sr::errors | flash_sr::done);  // writing 1 clears a flag
    }
    return is_idle;
}

/// Waits for the end of an operation. Returns whether it has succeeded. A write to FLASH_CR while the flash is busy
/// would stop the processor until the flash is ready (RM0090 3.6.1), so this register then stays as it is.
static_assert(implements<req::CO_FLASH_001> && implements<req::CO_FLASH_004>);
bool Flash::end_operation() noexcept {
    bool done{false};
    if (wait()) {
        done = !registers_.status.has(flash_sr::errors);
        registers_.control.write(0U);
    }
    return done;
}

static_assert(implements<req::CO_FLASH_001>);
bool Flash::erase(const std::uint32_t sector) noexcept {
    if (!is_ready()) {
        return false;
    }
    const std::uint32_t command = flash_cr::erase_sector | flash_cr::by_words | (sector << flash_cr::sector_shift);
    registers_.control.write(command);
    registers_.control.write(command | flash_cr::start);
    return end_operation();
}

static_assert(implements<req::CO_FLASH_001>);
bool Flash::program(Register& word, const std::uint32_t value) noexcept {
    if (!is_ready()) {
        return false;
    }
    registers_.control.write(flash_cr::program | flash_cr::by_words);
    word.write(value);
    return end_operation() && (word.read() == value);
}

}  // namespace canproof::stm32f405
