// SPDX-License-Identifier: Apache-2.0
// Time in the firmware: a 64-bit count of microseconds that the caller passes in. Only the code in host/ and target/
// reads a clock.
#pragma once

#include <cstdint>

namespace canproof {

/// A length of time in microseconds; 64 bits hold more than 500,000 years.
struct Duration {
    std::uint64_t us{0U};
};

/// A point in time: microseconds since an epoch that the caller chooses and keeps.
struct Instant {
    std::uint64_t us{0U};
};

constexpr Duration microseconds(const std::uint64_t count) noexcept {
    return Duration{count};
}
constexpr Duration milliseconds(const std::uint64_t count) noexcept {
    return Duration{count * 1000U};
}
/// Returns `count` times 100 µs, the unit of the inhibit times of CiA 301.
constexpr Duration hundreds_of_microseconds(const std::uint64_t count) noexcept {
    return Duration{count * 100U};
}

/// "At no time": later than every event. next_deadline() returns it when there is no deadline.
constexpr Instant never{UINT64_MAX};

constexpr bool operator==(const Instant a, const Instant b) noexcept {
    return a.us == b.us;
}
constexpr bool operator!=(const Instant a, const Instant b) noexcept {
    return a.us != b.us;
}
constexpr bool operator<(const Instant a, const Instant b) noexcept {
    return a.us < b.us;
}
constexpr bool operator<=(const Instant a, const Instant b) noexcept {
    return a.us <= b.us;
}
constexpr bool operator>(const Instant a, const Instant b) noexcept {
    return a.us > b.us;
}

/// Adds a duration. Saturates at `never`, so that a deadline cannot wrap into the past.
constexpr Instant operator+(const Instant start, const Duration length) noexcept {
    const std::uint64_t sum = start.us + length.us;
    return Instant{(sum < start.us) ? UINT64_MAX : sum};
}

/// Returns the microseconds of the sum of an instant and a duration, both in microseconds; see operator+.
[[gnu::noinline]] std::uint64_t sum_or_never(std::uint64_t start, std::uint64_t length) noexcept;
/// Adds a duration as operator+ does, by a function call: for code that runs seldom, because a saturating sum of 64
/// bits takes many instructions on a 32-bit processor.
inline Instant later(const Instant start, const Duration length) noexcept {
    return Instant{sum_or_never(start.us, length.us)};
}

/// Returns the time from `earlier` to `later`; zero when `later` is not after `earlier`.
constexpr Duration elapsed(const Instant earlier, const Instant later) noexcept {
    return (later.us > earlier.us) ? Duration{later.us - earlier.us} : Duration{0U};
}

constexpr Instant earliest(const Instant a, const Instant b) noexcept {
    return Instant{(a.us < b.us) ? a.us : b.us};
}

/// Returns whether the time `next` of an event that comes in each `period` is due: it is reached, or more than a period
/// ahead. Only a changed bit in RAM moves it so far ahead.
constexpr bool is_due(const Instant next, const Duration period, const Instant now) noexcept {
    return (next <= now) || (next > (now + period));
}

/// Returns the next time of an event that is due by is_due(): one period after `due`, or after `now` if this time is
/// over or `due` was too far ahead.
constexpr Instant next_after(const Instant due, const Duration period, const Instant now) noexcept {
    const Instant in_step = due + period;
    const bool is_in_step = (due <= now) && (in_step > now);
    return is_in_step ? in_step : (now + period);
}

}  // namespace canproof
