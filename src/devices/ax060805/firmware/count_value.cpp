// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/count_value.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr float lowest = -32768.0F;
constexpr float highest = 32767.0F;
constexpr float highest_milliseconds = 65535.0F;
constexpr float digits_of_whole_units = 1000.0F;  // ReceivedScale::digits for which one received count is one unit

}  // namespace

static_assert(implements<req::INC_FV_001> && implements<req::INC_FV_002> && implements<req::INC_FV_003>);
std::int16_t count_value(const float value, const CountScale& scale) noexcept {
    const float counts = (value * static_cast<float>(scale.digits)) + scale.offset;
    if (std::isnan(counts)) {
        return 0;
    }
    const float clamped = std::fmin(std::fmax(counts, lowest), highest);
    return static_cast<std::int16_t>(std::round(clamped));
}

std::uint16_t whole_milliseconds(const float milliseconds) noexcept {
    if (!(milliseconds > 0.0F)) {
        return 0U;
    }
    return static_cast<std::uint16_t>(std::round(std::fmin(milliseconds, highest_milliseconds)));
}

float value_of_count(const std::int16_t count, const ReceivedScale& scale) noexcept {
    return ((static_cast<float>(count) + scale.offset) * static_cast<float>(scale.digits)) / digits_of_whole_units;
}

}  // namespace canproof::ax060805
