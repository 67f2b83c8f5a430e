// SPDX-License-Identifier: Apache-2.0
// Math blocks: three functions, chained over four inputs (AX130751, 1.7). The operators of Table 21 come from the
// requirements register.
#pragma once

#include <array>

#include "devices/ax130751/firmware/block_signal.hpp"

namespace canproof::ax130751 {

constexpr std::size_t math_inputs = 4U;
constexpr std::size_t math_functions = 3U;

struct MathInput {
    BlockSignal signal{};
    double scaling_1{0.0};          ///< value of the signal for the fraction 0
    double scaling_2{100.0};        ///< value of the signal for the fraction 1
    double gain{1.0};               ///< -1…1
    std::uint8_t own_function{0U};  ///< 1…3: use the result of that function of this block instead of the signal
};

struct MathConfig {
    std::array<MathInput, math_inputs> inputs{};
    std::array<std::uint8_t, math_functions> operators{};  ///< operators of Table 21
};

/// Returns a signal as a fraction of its scaling, 0…1, in steps of a millionth, before the gain. Returns 0 when the
/// signal is not valid or both scalings are equal.
double math_fraction(const MathInput& input) noexcept;

/// Applies an operator of the manual's Table 21 to two inputs. Comparisons and logic give 0 or 1, differences keep
/// their sign, and a division by 0 gives 0. An unknown operator counts as addition.
double apply_operator(std::uint8_t number, double a, double b) noexcept;

struct MathResult {
    double value{0.0};
    bool done{false};  ///< false: no function had both of its inputs
};

/// The result of one of the three functions of a block, in two forms.
struct MathFunction {
    double value{0.0};
    double with_sign{0.0};  ///< the same result, but a negative difference keeps its sign
};

class MathBlock {
  public:
    /// Evaluates the block. Returns the result of the last function that had both inputs, as a fraction: 1 is full
    /// scale, values outside 0…1 are possible. Each result is clamped to ±1e9. A result smaller than 1e-290 in
    /// size becomes 0.
    MathResult advance(const MathConfig& config) noexcept;
    void reset() noexcept { *this = MathBlock{}; }
    /// Returns whether the last cycle gave the same results as the previous one; with the same inputs, the next cycle
    /// then gives these results too.
    bool is_settled() const noexcept { return settled_; }

  private:
    double input_value(const MathInput& input) const noexcept;

    bool settled_{true};
    /// Results of the three functions. Until a cycle evaluates a function, its result is that of the previous cycle.
    std::array<MathFunction, math_functions> results_{};
};

/// Returns the output of a block: `scaling_1` for the fraction 0, `scaling_2` for 1, linear between them. Clamps the
/// fraction to 0…1.
double math_output(double fraction, double scaling_1, double scaling_2) noexcept;

}  // namespace canproof::ax130751
