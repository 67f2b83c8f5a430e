// SPDX-License-Identifier: Apache-2.0
// The controller of the flash memory: erases a sector, programs a word (RM0090 3.5 to 3.9). Meanwhile the processor
// stops at its next fetch from flash; no interrupt runs.
#pragma once

#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

struct FlashRegisters {
    Register access_control;  ///< 00h FLASH_ACR (3.9.1)
    Register key;             ///< 04h FLASH_KEYR (3.9.3)
    Register option_key;      ///< 08h FLASH_OPTKEYR (3.9.4)
    Register status;          ///< 0Ch FLASH_SR (3.9.5)
    Register control;         ///< 10h FLASH_CR (3.9.7)
    Register option_control;  ///< 14h FLASH_OPTCR (3.9.9)
};

namespace flash_acr {
constexpr std::uint32_t latency = 0x7U;          // LATENCY, wait states
constexpr std::uint32_t prefetch = bit(8U);      // PRFTEN
constexpr std::uint32_t instructions = bit(9U);  // ICEN
constexpr std::uint32_t data = bit(10U);         // DCEN
constexpr std::uint32_t reset_data = bit(12U);   // DCRST
}  // namespace flash_acr

namespace flash_sr {
constexpr std::uint32_t done = bit(0U);   // EOP
constexpr std::uint32_t errors = 0xF2U;   // OPERR, WRPERR, PGAERR, PGPERR, PGSERR
constexpr std::uint32_t busy = bit(16U);  // BSY
}  // namespace flash_sr

namespace flash_cr {
constexpr std::uint32_t program = bit(0U);       // PG
constexpr std::uint32_t erase_sector = bit(1U);  // SER
constexpr std::uint32_t sector_shift = 3U;       // SNB
constexpr std::uint32_t by_words = 0x2U << 8U;   // PSIZE: 32 bits, for a supply of 2.7 to 3.6 V
constexpr std::uint32_t start = bit(16U);        // STRT
constexpr std::uint32_t lock = bit(31U);         // LOCK
}  // namespace flash_cr

class Flash {
  public:
    /// The limit of polls for an operation. Erasing 16 KiB takes at most 0.5 s (data sheet); a poll takes at least six
    /// cycles of 168 MHz, so this number of polls takes at least 0.7 s.
    static constexpr std::uint32_t usual_polls = 20000000U;

    explicit Flash(FlashRegisters& registers, const std::uint32_t most_polls = usual_polls) noexcept
        : registers_{registers}, most_polls_{most_polls} {}

    /// Enables erase() and program() until finish(), and switches the data cache off meanwhile.
    void begin() noexcept;
    void finish() noexcept;
    /// Erases a sector (0…11): sets all its bits. Returns false when the controller reports an error or does not
    /// finish.
    bool erase(std::uint32_t sector) noexcept;
    /// Programs an erased word. Returns false in the same cases as erase(), and when the word does not have the value
    /// afterwards.
    bool program(Register& word, std::uint32_t value) noexcept;

  private:
    bool wait() const noexcept;
    bool is_ready() noexcept;
    bool end_operation() noexcept;

    FlashRegisters& registers_;
    std::uint32_t most_polls_;
};

}  // namespace canproof::stm32f405
