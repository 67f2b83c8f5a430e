// SPDX-License-Identifier: Apache-2.0
// The complement of a device's outputs, kept while the device does not compute, so that a change of the outputs in RAM
// is noticed.
#pragma once

#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

/// `Outputs`: the outputs as plain data. The padding between its members is compared too; nothing changes it either.
template <typename Outputs>
class OutputCopy {
  public:
    static_assert(std::is_trivially_copyable_v<Outputs>, "outputs are plain data");

    void keep(const Outputs& outputs) noexcept {
        const Parts parts = bit_cast<Parts>(outputs);
        for (std::size_t i = 0U; i < complement_.size(); ++i) {
            complement_[i] = ~std::uint32_t{parts[i]};
        }
    }
    /// Returns whether the outputs equal those at the last keep().
    bool matches(const Outputs& outputs) const noexcept {
        static_assert(implements<req::CO_SELF_007>);
        const Parts parts = bit_cast<Parts>(outputs);
        bool same{true};
        for (std::size_t i = 0U; i < complement_.size(); ++i) {
            same = (complement_[i] == ~std::uint32_t{parts[i]}) && same;
        }
        return same;
    }

  private:
    /// A word, or a byte when the size of the outputs is not a whole number of words.
    using Part = std::conditional_t<(sizeof(Outputs) % sizeof(std::uint32_t)) == 0U, std::uint32_t, std::uint8_t>;
    using Parts = std::array<Part, sizeof(Outputs) / sizeof(Part)>;

    std::array<std::uint32_t, std::tuple_size_v<Parts>> complement_{};
};

}  // namespace canproof::stm32f405
