// SPDX-License-Identifier: Apache-2.0
// The complement of a device's outputs, kept while the device does not compute, so that a change of the outputs in RAM
// is noticed.
#pragma once

#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

/// `Outputs`: the outputs as plain data. Bytes between its members are compared too; nothing changes them either.
template <typename Outputs>
class OutputCopy {
  public:
    static_assert(std::is_trivially_copyable_v<Outputs>, "outputs are plain data");

    void keep(const Outputs& outputs) noexcept {
        const Bytes bytes = bit_cast<Bytes>(outputs);
        for (std::size_t i = 0U; i < complement_.size(); ++i) {
            complement_[i] = ~read_u32(ByteView{bytes}, i * sizeof(std::uint32_t));
        }
    }
    /// Returns whether the outputs are those that were kept.
    bool matches(const Outputs& outputs) const noexcept {
        static_assert(implements<req::CO_SELF_007>);
        const Bytes bytes = bit_cast<Bytes>(outputs);
        bool same{true};
        for (std::size_t i = 0U; i < complement_.size(); ++i) {
            same = (complement_[i] == ~read_u32(ByteView{bytes}, i * sizeof(std::uint32_t))) && same;
        }
        return same;
    }

  private:
    using Bytes = std::array<std::uint8_t, sizeof(Outputs)>;

    static constexpr std::size_t words_of(const std::size_t bytes) noexcept {
        return (bytes + 3U) / sizeof(std::uint32_t);
    }

    std::array<std::uint32_t, words_of(sizeof(Outputs))> complement_{};
};

}  // namespace canproof::stm32f405
