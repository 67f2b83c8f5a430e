// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/state_guard.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/selftest/core.hpp"

namespace canproof::stm32f405 {

namespace {

constexpr std::size_t word = sizeof(std::uint32_t);
constexpr std::size_t block = 8U * word;

}  // namespace

/// Adds blocks of eight words by core_sum(), because a device computes this sum twice for each computation, then the
/// rest.
static_assert(implements<req::CO_SELF_011>);
std::uint32_t StateGuard::sum() const noexcept {
    const std::size_t blocks = object_.size() / block;
    std::uint32_t sum = core_sum(0U, object_.data(), static_cast<std::uint32_t>(blocks * 8U));
    for (std::size_t at = blocks * block; at < object_.size(); at += word) {
        sum = ((sum << 1U) | (sum >> 31U)) + read_u32(object_, at);
    }
    return sum;
}

}  // namespace canproof::stm32f405
