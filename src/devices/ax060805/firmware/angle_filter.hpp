// SPDX-License-Identifier: Apache-2.0
// Additional filters of one angle: moving average and repeating filter (AX060805, 3.3 Table 4, 4.3.10 to 4.3.12).
//
// The memory and the computing time of a filter do not grow with its window. A window of up to 64 samples stores each
// of them. A longer window is divided into up to 64 runs of equal length and stores only their sums; the oldest run
// counts in proportion to its part inside the window. Sums are integers in microdegrees, so that no rounding error
// accumulates and the order of addition does not matter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "generated/ax060805/tables.hpp"

namespace canproof::ax060805 {

/// The kinds of filter and their outputs. none: the latest sample. moving_average: the mean of the latest samples.
/// repeating: the mean of a block of samples, repeated while the next block is collected.
using AngleFilterKind = generated::ax060805::angle_filter::Filter;

class AngleFilter {
  public:
    /// Sets the output to 0 after a reset of the device. The caller then calls restart().
    void forget() noexcept { output_ = 0.0F; }
    /// Starts again with a window of `samples`, 1…60000 (0 counts as 1). The output stays until the next sample.
    /// `is_circular`: the angle goes on at -180 when it passes 180. It is false for an angle whose whole range is half
    /// a turn.
    void restart(AngleFilterKind kind, std::uint16_t samples, bool is_circular = true) noexcept;
    /// Adds one sample, -180…180 degrees. For a circular angle, assumes the shorter of the two rotations from the
    /// sample before it, so that the mean of 179 and -179 is 180 and not 0.
    void add(float degrees) noexcept;
    /// Returns the filtered angle, -180…180 degrees; 0 before the first sample. Until the window of a filter is full,
    /// the angle is the mean of the samples so far.
    float output() const noexcept { return output_; }

  private:
    static constexpr std::size_t run_capacity = 64U;

    std::int64_t unwrap(float degrees) noexcept;
    void rebase() noexcept;
    void add_to_window(std::int64_t turned) noexcept;
    void add_to_block(std::int64_t turned) noexcept;
    std::int64_t mean_of_window() const noexcept;

    std::array<std::int64_t, run_capacity> runs_{};  ///< ring buffer: the sum of each complete run of samples
    std::size_t newest_{0U};                         ///< position in runs_ of the latest complete run
    std::int64_t sum_{0};                            ///< sum of the samples of the incomplete run or block
    std::int32_t collected_{0};                      ///< number of samples in sum_
    std::int32_t seen_{0};                           ///< number of samples since restart(), at most `samples_`
    std::int64_t turned_{0};                         ///< latest sample including whole turns, microdegrees
    float output_{0.0F};
    std::int32_t samples_{1};
    std::int32_t run_length_{1};
    AngleFilterKind kind_{AngleFilterKind::none};
    bool block_complete_{false};
    bool is_circular_{true};
};

/// Returns the delay, in milliseconds, with which the output follows a slow change of the angle: half the time from the
/// first to the last sample of a window. The repeating filter adds half the duration of a block, because its output
/// keeps one value for a whole block.
float angle_filter_delay_ms(AngleFilterKind kind, std::uint16_t samples, std::uint16_t period_ms) noexcept;

}  // namespace canproof::ax060805
