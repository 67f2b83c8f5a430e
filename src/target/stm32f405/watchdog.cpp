// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/watchdog.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// Keys, the prescaler that divides 32 kHz by 32, and the flags of a pending new value (RM0090 21.4).
constexpr std::uint32_t key_start = 0xCCCCU;
constexpr std::uint32_t key_access = 0x5555U;
constexpr std::uint32_t key_refresh = 0xAAAAU;
constexpr std::uint32_t by_32 = 0x3U;
constexpr std::uint32_t updating = 0x3U;

}  // namespace

static_assert(implements<req::CO_WATCHDOG_001> && implements<req::CO_WATCHDOG_003>);
bool Watchdog::start() noexcept {
    registers_.key.write(key_start);
    registers_.key.write(key_access);
    registers_.prescaler.write(by_32);
    registers_.reload.write(period_ms - 1U);
    const bool taken = waits_for_update();
    refresh();
    return taken;
}

bool Watchdog::waits_for_update() const noexcept {
    for (std::uint32_t poll = 0U; poll < most_polls_; ++poll) {
        if (!registers_.status.has(updating)) {
            return true;
        }
    }
    return false;
}

void Watchdog::refresh() noexcept {
    registers_.key.write(key_refresh);
}

}  // namespace canproof::stm32f405
