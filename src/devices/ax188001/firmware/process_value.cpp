// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/firmware/process_value.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "firmware/blocks/bounds.hpp"
#include "generated/ax188001/requirements.hpp"

namespace canproof::ax188001 {

static_assert(implements<req::TCS_VAL_001> && implements<req::TCS_VAL_003> && implements<req::TCS_VAL_004>);
std::int16_t process_value(const double field_value, const Scaling& scaling) noexcept {
    constexpr double highest = 32767.0;
    constexpr double lowest = -32768.0;
    const double scaled = std::round((field_value * scaling.factor) + scaling.offset);
    return static_cast<std::int16_t>(lesser(greater(scaled, lowest), highest));
}

static_assert(implements<req::TCS_VAL_007>);
std::int16_t measured_process_value(const double field_value, const Scaling& scaling,
                                    const ReservedValues& reserved) noexcept {
    const std::int16_t value = process_value(field_value, scaling);
    const bool taken = (value == reserved.disabled) || (value == reserved.open);
    return taken ? static_cast<std::int16_t>(value + 1) : value;
}

}  // namespace canproof::ax188001
