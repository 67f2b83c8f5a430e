// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/time_base.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

void TimeBase::start() noexcept {
    timer_.prescaler.write(timer_mhz_ - 1U);
    timer_.reload.write(UINT32_MAX);
    timer_.events.write(tim::update);  // an update makes the prescaler effective (RM0090 18.3.1)
    timer_.counter.write(0U);
    timer_.control.write(tim::enable);
    last_ = 0U;
    wraps_ = 0U;
}

static_assert(implements<req::CO_CLOCK_002>);
Instant TimeBase::now() noexcept {
    const std::uint32_t count = timer_.counter.read();
    wraps_ += (count < last_) ? 1U : 0U;
    last_ = count;
    return Instant{(wraps_ << 32U) | count};
}

}  // namespace canproof::stm32f405
