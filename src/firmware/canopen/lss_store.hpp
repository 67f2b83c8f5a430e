// Node-ID and bit rate in the non-volatile memory: what LSS stores (CiA 305, 6.4.5). Two slots take turns as the banks
// of ParameterStore do, so that a power cut at any byte leaves the old configuration or the new one, and a damaged slot
// is neither.
#pragma once

#include "firmware/base/commit_marker.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/lss.hpp"

namespace canproof {

class LssStore {
  public:
    static constexpr std::size_t slot_size = 20U;
    static constexpr std::size_t slot_count = 2U;
    /// Bytes at the end of the memory; the parameters begin at its start.
    static constexpr std::size_t size = slot_size * slot_count;

    explicit LssStore(NonVolatileMemory& memory) noexcept : memory_{memory} {}

    /// What was stored last, or `shipped` when nothing is stored, or when what is stored is damaged or has no node-ID
    /// that LSS gives.
    LssConfiguration load(const LssConfiguration& shipped) const noexcept;
    /// LssError::storage_failed when the memory failed; what was stored before is then still stored.
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
