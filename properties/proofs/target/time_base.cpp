// SPDX-License-Identifier: Apache-2.0
// Theorem on the clock of the microcontroller, which extends a timer of 32 bits to 64 bits.
#include "target/stm32f405/time_base.cpp"

#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

stm32f405::TimerRegisters registers{};
std::uint32_t shown_count{0U};  ///< value that the timer register shows when it is read

}  // namespace

}  // namespace canproof::proofs

namespace canproof::stm32f405 {

std::uint32_t Register::read() const noexcept {
    return proofs::shown_count;
}
void Register::write(const std::uint32_t /*bits*/) noexcept {}

}  // namespace canproof::stm32f405

namespace canproof::proofs {

void the_clock_counts_on_across_the_wrap() {
    shows(
        "the clock shows the microseconds since start, also across each wrap of its 32-bit timer, when it is read at "
        "least once within 2^32 us");
    proves<req::CO_CLOCK_002>();
    stm32f405::TimeBase clock{registers, 84U};
    const auto before = any<std::uint64_t>();
    const auto later = any<std::uint64_t>();
    clock.last_ = static_cast<std::uint32_t>(before & UINT32_MAX);
    clock.wraps_ = before >> 32U;
    assume((later >= before) && ((later - before) <= UINT32_MAX));
    shown_count = static_cast<std::uint32_t>(later & UINT32_MAX);
    claim(clock.now().us == later);
    claim((clock.last_ == shown_count) && (clock.wraps_ == (later >> 32U)));
}

void the_clock_starts_at_zero() {
    shows("after start() the clock shows the time that its timer shows");
    proves<req::CO_CLOCK_002>();
    stm32f405::TimeBase clock{registers, any<std::uint32_t>()};
    clock.start();
    shown_count = any<std::uint32_t>();
    claim(clock.now().us == shown_count);
}

}  // namespace canproof::proofs
