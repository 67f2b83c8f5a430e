// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/lss_fastscan.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::size_t id_number_at = 1U;
constexpr std::size_t bit_check_at = 5U;
constexpr std::size_t number_at = 6U;
constexpr std::size_t next_at = 7U;
constexpr std::uint32_t all_confirmed = (1U << lss_number_count) - 1U;

}  // namespace

void LssFastscan::restart() noexcept {
    position_ = static_cast<std::uint8_t>(LssNumber::vendor_id);
    confirmed_ = 0U;
}

LssFastscan::Outcome LssFastscan::scan(const Request& request, const std::uint32_t own) noexcept {
    const std::uint32_t bit_check = request[bit_check_at];
    const std::uint8_t next = request[next_at];
    static_assert(implements<req::CO_LSS_051> && implements<req::CO_K_LSS_RESTART> && implements<req::CO_LSS_083>);
    if (bit_check == generated::canopen::fastscan_restart) {
        restart();
        return Outcome::matched;
    }
    static_assert(implements<req::CO_LSS_055> && implements<req::CO_K_LSS_HIGHEST_BIT> && implements<req::CO_LSS_084>);
    const bool is_sound = (bit_check <= generated::canopen::fastscan_highest_bit) && (next < lss_number_count);
    static_assert(implements<req::CO_LSS_079>);
    if (!is_sound || (std::uint32_t{request[number_at]} != position_) || !matches(request, own)) {
        return Outcome::silent;
    }
    const bool confirms = (bit_check == 0U) && (std::uint32_t{next} != position_);
    return confirms ? confirm(next) : Outcome::matched;
}

static_assert(implements<req::CO_LSS_052> && implements<req::CO_E_LSS_NUMBER>);
bool LssFastscan::matches(const Request& request, const std::uint32_t own) noexcept {
    const std::uint32_t differing = own ^ static_cast<std::uint32_t>(field_le<id_number_at, 4U>(request));
    return (differing >> std::uint32_t{request[bit_check_at]}) == 0U;
}

// After the vendor-ID a master may ask for the other numbers in any order, but cannot omit one (CO-D-LSS-004).
static_assert(implements<req::CO_LSS_053> && implements<req::CO_LSS_054>);
LssFastscan::Outcome LssFastscan::confirm(const std::uint8_t next) noexcept {
    confirmed_ |= std::uint32_t{1U} << std::uint32_t{position_};
    position_ = next;
    if (confirmed_ != all_confirmed) {
        return Outcome::matched;
    }
    restart();
    return Outcome::completed;
}

}  // namespace canproof
