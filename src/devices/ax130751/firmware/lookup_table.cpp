// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/lookup_table.hpp"

#include <cstdint>
#include <limits>

#include "devices/ax130751/firmware/linear_scaling.hpp"
#include "devices/ax130751/firmware/number_order.hpp"
#include "firmware/base/bytes.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

static_assert(implements<req::AOR_LT_005> && implements<req::AOR_LT_020> && implements<req::AOR_LT_006>);
double lookup(const double x, const LookupPoints& points) noexcept {
    static_assert(implements<req::AOR_LT_001>);
    // NaN counts as a number beyond all points.
    const std::uint64_t order = order_of(lesser(x, std::numeric_limits<double>::infinity()));
    static_assert(implements<req::AOR_LT_036>);
    if (order <= order_of(points.x[0U])) {
        return points.y[0U];
    }
    for (std::size_t point = 1U; point < lookup_points; ++point) {
        const std::size_t before = point - 1U;
        static_assert(implements<req::AOR_LT_004>);
        if (points.response[point] == PointResponse::ignore) {
            return points.y[before];
        }
        const std::uint64_t here = order_of(points.x[point]);
        if (order <= here) {
            static_assert(implements<req::AOR_LT_002> && implements<req::AOR_LT_003> && implements<req::AOR_LT_019>);
            const bool jumps = (order == here) || (points.response[point] == PointResponse::jump);
            const LinearScaling stretch{points.x[before], points.x[point], points.y[before], points.y[point]};
            return jumps ? points.y[point] : on_line(x, stretch);
        }
    }
    static_assert(implements<req::AOR_LT_037>);
    return points.y[lookup_points - 1U];
}

namespace {

/// Converts a whole number, 0 to below 2^53. The conversion by the library takes 400 instructions.
std::uint64_t whole(const double value) noexcept {
    constexpr std::uint32_t fraction_bits{52U};
    constexpr std::uint64_t hidden_bit = std::uint64_t{1U} << fraction_bits;
    constexpr std::uint32_t exponent_of_1{1023U};
    constexpr std::uint32_t most_places{63U};  // keeps the shift defined for every double
    const auto bits = bit_cast<std::uint64_t>(value);
    const std::uint32_t exponent = static_cast<std::uint32_t>(bits >> fraction_bits) & 0x7FFU;
    const std::uint32_t places = ((exponent_of_1 + fraction_bits) - exponent) & most_places;
    return (exponent < exponent_of_1) ? 0U : (((bits & (hidden_bit - 1U)) | hidden_bit) >> places);
}

}  // namespace

static_assert(implements<req::AOR_LT_011> && implements<req::AOR_LT_012>);
LookupPoints profile_of(const LookupPoints& intervals) noexcept {
    // A profile lasts at most ten times 24 hours, which is 8.64e11 µs. A double holds every sum of whole microseconds
    // below 9e15 exactly.
    static_assert(implements<req::AOR_LT_022>);
    LookupPoints profile{intervals};
    profile.x[0U] = 0.0;
    for (std::size_t point = 1U; point < lookup_points; ++point) {
        profile.x[point] += profile.x[point - 1U];
    }
    return profile;
}

Duration profile_length(const LookupPoints& profile) noexcept {
    for (std::size_t point = 1U; point < lookup_points; ++point) {
        if (profile.response[point] == PointResponse::ignore) {
            return Duration{whole(profile.x[point - 1U])};
        }
    }
    return Duration{whole(profile.x[lookup_points - 1U])};
}

static_assert(implements<req::AOR_LT_013>);
double lookup_in_time(const Duration running, const LookupPoints& profile, const bool repeat) noexcept {
    // Only a repeated profile needs its length here. LookupTable::follow_time() needs the length only without
    // repetition, so a cycle computes it once.
    const std::uint64_t length = repeat ? profile_length(profile).us : 0U;
    const bool wraps = (length != 0U) && (running.us > length);
    const std::uint64_t position = wraps ? (((running.us - 1U) % length) + 1U) : running.us;
    return lookup(static_cast<double>(position), profile);
}

LookupLimits lookup_limits(const LookupPoints& points) noexcept {
    LookupLimits limits{points.y[0U], points.y[0U]};
    for (const double y : points.y) {
        limits.least = (order_of(y) < order_of(limits.least)) ? y : limits.least;
        limits.greatest = (order_of(y) > order_of(limits.greatest)) ? y : limits.greatest;
    }
    return limits;
}

static_assert(implements<req::AOR_LT_015> && implements<req::AOR_LT_016>);
LookupOutput LookupTable::advance(const BlockSignal& input, const LookupConfig& config, const Instant now) noexcept {
    if (!input.is_available()) {
        reset();
        return LookupOutput{};
    }
    if (config.axis == LookupAxis::time) {
        value_ = follow_time(input, config, now);
    } else {
        static_assert(implements<req::AOR_LT_021>);
        start_ = DigitalReading{};  // a profile that is selected later begins with its input OFF
        running_ = false;
        under_way_ = false;
        static_assert(implements<req::AOR_LT_025>);
        value_ = input.is_valid() ? lookup(input.value, config.points) : value_;
    }
    return LookupOutput{value_, input.state};
}

static_assert(implements<req::AOR_LT_010>);
double LookupTable::follow_time(const BlockSignal& input, const LookupConfig& config, const Instant now) noexcept {
    static_assert(implements<req::AOR_LT_026> && implements<req::AOR_LT_030>);
    const bool on = start_.read(input) && input.is_valid();
    static_assert(implements<req::AOR_LT_029>);
    if (!on) {
        under_way_ = false;
        running_ = false;
        return 0.0;
    }
    if (!under_way_) {
        under_way_ = true;
        started_ = now;
    }
    const Duration gone = elapsed(started_, now);
    running_ = config.repeat || (gone.us < profile_length(config.points).us);
    return lookup_in_time(gone, config.points, config.repeat);
}

}  // namespace canproof::ax130751
