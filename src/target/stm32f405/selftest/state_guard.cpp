// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/state_guard.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/selftest/core.hpp"

namespace canproof::stm32f405 {

static_assert(implements<req::CO_SELF_011> && implements<req::CO_SELF_017>);
std::uint32_t StateGuard::sum() const noexcept {
    return core_sum(0U, object_.data(), static_cast<std::uint32_t>(object_.size() / sizeof(std::uint32_t)));
}

}  // namespace canproof::stm32f405
