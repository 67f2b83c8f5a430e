// Additional filters of one angle: moving average and repeating filter (AX060805, 3.3 Table 4, 4.3.10 to 4.3.12).
//
// Memory and work do not grow with the window. Up to 64 samples each is kept; a longer window is cut into up to 64 runs
// of equal length, of which only the sums are kept, and the oldest run counts by the share of it that is inside the
// window. Sums are whole numbers of microdegrees, so that nothing drifts and the order of addition does not matter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "generated/ax060805/tables.hpp"

namespace canproof::ax060805 {

/// none: the latest sample. moving_average: the mean of the latest samples. repeating: the mean of a block of samples,
/// repeated while the next block is collected.
using AngleFilterKind = generated::ax060805::angle_filter::Filter;

class AngleFilter {
  public:
    /// Power-on: nothing has been put out yet. restart() follows.
    void forget() noexcept { output_ = 0.0F; }
    /// Begins anew with a window of `samples`, 1…60000 (0 counts as 1). The output stays until there is a sample.
    void restart(AngleFilterKind kind, std::uint16_t samples) noexcept;
    /// Takes one sample, -180…180 degrees. It is understood as the nearest turn to the sample before, so that averages
    /// go the short way round.
    void add(float degrees) noexcept;
    /// -180…180 degrees; 0 before the first sample. Until a window is full, the mean of the samples so far.
    float output() const noexcept { return output_; }

  private:
    static constexpr std::size_t run_capacity = 64U;

    std::int64_t unwrap(float degrees) noexcept;
    void rebase() noexcept;
    void add_to_window(std::int64_t turned) noexcept;
    void add_to_block(std::int64_t turned) noexcept;
    std::int64_t mean_of_window() const noexcept;

    std::array<std::int64_t, run_capacity> runs_{};  ///< sums of whole runs, a ring
    std::size_t newest_{0U};                         ///< where the latest whole run stands
    std::int64_t sum_{0};                            ///< of the run or block that is being collected
    std::int32_t collected_{0};                      ///< samples in it
    std::int32_t seen_{0};                           ///< samples so far, at most those of a window
    std::int64_t turned_{0};                         ///< latest sample with the turns before it, microdegrees
    float output_{0.0F};
    std::int32_t samples_{1};
    std::int32_t run_length_{1};
    AngleFilterKind kind_{AngleFilterKind::none};
    bool block_complete_{false};
};

/// Delay of slow changes in milliseconds: half the window, and for the repeating filter the mean time of repetition.
float angle_filter_delay_ms(AngleFilterKind kind, std::uint16_t samples, std::uint16_t period_ms) noexcept;

}  // namespace canproof::ax060805
