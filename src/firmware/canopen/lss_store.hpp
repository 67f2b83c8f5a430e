// Node-ID and bit rate in the non-volatile memory: what LSS stores (CiA 305, 6.4.5). Two slots take turns, so that a
// power cut at any byte leaves the old configuration or the new one.
#pragma once

#include <optional>

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

    /// What was stored last, or `shipped` when nothing sound is stored.
    LssConfiguration load(const LssConfiguration& shipped) const noexcept;
    /// LssError::storage_failed when the memory failed; what was stored before is then still stored.
    LssError store(const LssConfiguration& configuration) noexcept;

  private:
    struct Slot {
        std::uint32_t sequence{0U};
        LssConfiguration configuration{};
    };

    std::size_t address(std::size_t slot) const noexcept;
    std::optional<Slot> read(std::size_t slot) const noexcept;
    bool write(std::size_t slot, const Slot& content) noexcept;

    NonVolatileMemory& memory_;
};

}  // namespace canproof
