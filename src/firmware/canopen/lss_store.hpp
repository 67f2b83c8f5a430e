// SPDX-License-Identifier: Apache-2.0
// Stores the node-ID and bit rate of LSS in the non-volatile memory (CiA 305, 6.4.5). Two slots alternate as the banks
// of ParameterStore do: a power cut at any byte leaves the old settings or the new ones, and a damaged slot is
// recognised.
#pragma once

#include "firmware/base/commit_marker.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/lss.hpp"

namespace canproof {

class LssStore {
  public:
    static constexpr std::size_t slot_size = 20U;
    static constexpr std::size_t slot_count = 2U;
    /// Number of bytes used at the end of the memory; the parameters use its start.
    static constexpr std::size_t size = slot_size * slot_count;

    explicit LssStore(NonVolatileMemory& memory) noexcept : memory_{memory} {}

    /// Returns the settings stored last. Returns `shipped` when nothing is stored, the stored settings are damaged, or
    /// their node-ID is one that LSS cannot assign. `damaged` of the result is set when the stored settings are
    /// damaged.
    LssConfiguration load(const LssConfiguration& shipped) const noexcept;
    /// Stores the settings. Returns LssError::storage_failed when the memory fails; the settings stored before then
    /// remain valid.
    LssError store(const LssConfiguration& configuration) noexcept;

  private:
    struct Slot {
        BankState state{BankState::unused};
        std::uint32_t sequence{0U};
        LssConfiguration configuration{};
    };

    std::size_t address(std::size_t slot) const noexcept;
    Slot read(std::size_t slot) const noexcept;
    static std::size_t latest_of(const Slot& first, const Slot& second) noexcept;
    bool write(std::size_t slot, const Slot& content) noexcept;
    bool write_marker(std::size_t slot, std::uint8_t marker) noexcept;

    NonVolatileMemory& memory_;
};

}  // namespace canproof
