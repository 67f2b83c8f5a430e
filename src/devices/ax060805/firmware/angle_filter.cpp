// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/angle_filter.hpp"

#include <algorithm>

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr float units_per_degree = 1.0e6F;
constexpr std::int64_t full_turn = 360'000'000;
constexpr std::int64_t half_turn = full_turn / 2;
// unwrap() calls rebase() when the angle exceeds this number of whole turns. Consecutive samples differ by at most half
// a turn, so no sample in a window of 60,000 samples exceeds 64 + 30,000 turns. The sum of this window is at
// most 6.5e17 microdegrees, which fits into 63 bits.
constexpr std::int64_t most_turns = 64;

std::int64_t to_units(const float degrees) noexcept {
    const float scaled = degrees * units_per_degree;
    return static_cast<std::int64_t>((scaled < 0.0F) ? (scaled - 0.5F) : (scaled + 0.5F));
}

/// Returns the same direction as an angle with -half_turn < units <= half_turn.
static_assert(implements<req::INC_ANGLE_014>);
std::int64_t wrapped(const std::int64_t units) noexcept {
    std::int64_t rest = units % full_turn;
    if (rest > half_turn) {
        rest -= full_turn;
    } else if (rest <= -half_turn) {
        rest += full_turn;
    } else {
        // the angle is in this range already
    }
    return rest;
}

float to_degrees(const std::int64_t units) noexcept {
    return static_cast<float>(wrapped(units)) / units_per_degree;
}

/// Divides and rounds to nearest, halves away from zero. `count` is at least 1.
std::int64_t rounded_quotient(const std::int64_t sum, const std::int64_t count) noexcept {
    const std::int64_t half = count / 2;
    return ((sum < 0) ? (sum - half) : (sum + half)) / count;
}

/// Returns sum * taken / length without a product that could overflow. All runs but the oldest are taken whole, and
/// need no division.
std::int64_t share_of(const std::int64_t sum, const std::int64_t taken, const std::int64_t length) noexcept {
    return (taken == length) ? sum : (((sum / length) * taken) + (((sum % length) * taken) / length));
}

}  // namespace

void AngleFilter::restart(const AngleFilterKind kind, const std::uint16_t samples, const bool is_circular) noexcept {
    kind_ = kind;
    is_circular_ = is_circular;
    samples_ = (samples == 0U) ? 1 : static_cast<std::int32_t>(samples);
    constexpr std::int32_t capacity = static_cast<std::int32_t>(run_capacity);
    static_assert(implements<req::INC_AVG_017>);
    run_length_ = ((samples_ + capacity) - 1) / capacity;
    seen_ = 0;  // mean_of_window() then ignores the sums that are still in runs_
    sum_ = 0;
    collected_ = 0;
    turned_ = 0;
    block_complete_ = false;
}

void AngleFilter::add(const float degrees) noexcept {
    const std::int64_t turned = unwrap(degrees);
    switch (kind_) {
        case AngleFilterKind::moving_average:
            add_to_window(turned);
            output_ = to_degrees(mean_of_window());
            break;
        case AngleFilterKind::repeating:
            add_to_block(turned);
            break;
        case AngleFilterKind::none:
        default:
            static_assert(implements<req::INC_AVG_007>);
            output_ = degrees;
            break;
    }
}

static_assert(implements<req::INC_AVG_006> && implements<req::INC_AVG_018>);
std::int64_t AngleFilter::unwrap(const float degrees) noexcept {
    const std::int64_t step = to_units(degrees) - turned_;
    turned_ += is_circular_ ? wrapped(step) : step;
    if ((turned_ > (most_turns * full_turn)) || (turned_ < (-most_turns * full_turn))) {
        rebase();
    }
    return turned_;
}

/// Subtracts the same number of whole turns from all stored angles, so that they do not overflow when a machine keeps
/// turning in one direction.
void AngleFilter::rebase() noexcept {
    const std::int64_t turns = (turned_ / full_turn) * full_turn;
    turned_ -= turns;
    sum_ -= turns * collected_;
    for (std::int64_t& run : runs_) {
        run -= turns * run_length_;
    }
}

void AngleFilter::add_to_window(const std::int64_t turned) noexcept {
    sum_ += turned;
    ++collected_;
    seen_ = std::min(seen_ + 1, samples_);
    static_assert(implements<req::INC_AVG_002> && implements<req::INC_AVG_008>);
    if (collected_ == run_length_) {
        newest_ = (newest_ + 1U) % run_capacity;
        runs_[newest_] = sum_;
        sum_ = 0;
        collected_ = 0;
    }
}

static_assert(implements<req::INC_AVG_001> && implements<req::INC_AVG_009> && implements<req::INC_AVG_010>);
std::int64_t AngleFilter::mean_of_window() const noexcept {
    std::int64_t sum = sum_;
    std::size_t at = newest_;
    for (std::int32_t missing = seen_ - collected_; missing >= 1; missing -= run_length_) {
        static_assert(implements<req::INC_AVG_016>);
        sum += share_of(runs_[at], std::min(missing, run_length_), run_length_);
        at = (at == 0U) ? (run_capacity - 1U) : (at - 1U);
    }
    return rounded_quotient(sum, seen_);
}

static_assert(implements<req::INC_AVG_003> && implements<req::INC_AVG_011>);
void AngleFilter::add_to_block(const std::int64_t turned) noexcept {
    sum_ += turned;
    ++collected_;
    const bool complete = collected_ == samples_;
    if (complete || !block_complete_) {
        output_ = to_degrees(rounded_quotient(sum_, collected_));
    }
    if (complete) {
        block_complete_ = true;
        sum_ = 0;
        collected_ = 0;
    }
}

float angle_filter_delay_ms(const AngleFilterKind kind, const std::uint16_t samples,
                            const std::uint16_t period_ms) noexcept {
    const float count = (samples == 0U) ? 1.0F : static_cast<float>(samples);
    const float period = static_cast<float>(period_ms);
    switch (kind) {
        case AngleFilterKind::moving_average:
            return ((count - 1.0F) * period) / 2.0F;
        case AngleFilterKind::repeating:
            return (((2.0F * count) - 1.0F) * period) / 2.0F;
        case AngleFilterKind::none:
        default:
            return 0.0F;
    }
}

}  // namespace canproof::ax060805
