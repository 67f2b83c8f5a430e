// SPDX-License-Identifier: Apache-2.0
// Monitors the program flow: each step of a pass of the main loop adds its number to a signature, which depends on the
// order of the steps.
#pragma once

#include <array>
#include <cstdint>

namespace canproof::stm32f405 {

/// The steps of a pass, in their order.
enum class Step : std::uint8_t { bus = 1U, inputs, device, transmit, outputs, tests };

class FlowMonitor {
  public:
    void note(const Step step) noexcept { signature_ = add(signature_, step); }

    /// Ends a pass. Returns whether each step was noted exactly once and in the right order since the last call. After
    /// one wrong pass, all later passes count as wrong too.
    bool end() noexcept {
        const bool is_right = signature_ == after_a_pass();
        signature_ = is_right ? start : ~after_a_pass();
        return is_right;
    }

  private:
    static constexpr std::uint32_t start = 0x811C9DC5U;

    /// Multiplying by an odd number keeps different signatures different. A test tries all sequences of up to six
    /// steps, and a correct pass with one additional step: only the correct pass has its signature.
    static constexpr std::uint32_t add(const std::uint32_t signature, const Step step) noexcept {
        return (signature ^ static_cast<std::uint32_t>(step)) * 0x01000193U;
    }
    static constexpr std::uint32_t after_a_pass() noexcept {
        constexpr std::array<Step, 6U> steps{Step::bus,      Step::inputs,  Step::device,
                                             Step::transmit, Step::outputs, Step::tests};
        std::uint32_t signature{start};
        for (const Step step : steps) {
            signature = add(signature, step);
        }
        return signature;
    }

    std::uint32_t signature_{start};
};

}  // namespace canproof::stm32f405
