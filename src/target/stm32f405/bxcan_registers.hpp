// SPDX-License-Identifier: Apache-2.0
// The registers of bxCAN (RM0090 32.9; offsets in 32.9.5). Each name spells out an abbreviated name of the manual,
// which is written beside it.
#pragma once

#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

constexpr std::size_t mailbox_count = 3U;
constexpr std::size_t fifo_count = 2U;
constexpr std::size_t fifo_depth = 3U;
constexpr std::size_t filter_bank_count = 28U;

/// A transmit mailbox (CAN_T…) or the output of a receive FIFO (CAN_R…).
struct Mailbox {
    Register identifier;  ///< CAN_TIxR, CAN_RIxR (32.9.3)
    Register length;      ///< CAN_TDTxR, CAN_RDTxR (32.9.3)
    Register data_low;    ///< CAN_TDLxR, CAN_RDLxR (32.9.3)
    Register data_high;   ///< CAN_TDHxR, CAN_RDHxR (32.9.3)
};

struct FilterBank {
    Register identifier;  ///< CAN_FiR1 (32.9.4)
    Register mask;        ///< CAN_FiR2 (32.9.4)
};

struct BxcanRegisters {
    Register master_control;                        ///< 000h CAN_MCR (32.9.2)
    Register master_status;                         ///< 004h CAN_MSR (32.9.2)
    Register transmit_status;                       ///< 008h CAN_TSR (32.9.2)
    std::array<Register, fifo_count> receive_fifo;  ///< 00Ch CAN_RF0R, 010h CAN_RF1R (32.9.2)
    Register interrupt_enable;                      ///< 014h CAN_IER (32.9.2)
    Register error_status;                          ///< 018h CAN_ESR (32.9.2)
    Register bit_timing;                            ///< 01Ch CAN_BTR (32.9.2)
    Reserved<88U> reserved_020{};
    std::array<Mailbox, mailbox_count> transmit;  ///< 180h
    std::array<Mailbox, fifo_count> receive;      ///< 1B0h
    Reserved<12U> reserved_1d0{};
    Register filter_master;  ///< 200h CAN_FMR (32.9.4)
    Register filter_mode;    ///< 204h CAN_FM1R (32.9.4)
    Reserved<1U> reserved_208{};
    Register filter_scale;  ///< 20Ch CAN_FS1R (32.9.4)
    Reserved<1U> reserved_210{};
    Register filter_fifo;  ///< 214h CAN_FFA1R (32.9.4)
    Reserved<1U> reserved_218{};
    Register filter_active;  ///< 21Ch CAN_FA1R (32.9.4)
    Reserved<8U> reserved_220{};
    std::array<FilterBank, filter_bank_count> filter_bank;  ///< 240h CAN_FiRx
};

static_assert(sizeof(BxcanRegisters) == 0x320U, "the last register of a filter bank lies at 31Ch");

namespace mcr {
constexpr std::uint32_t initialise = bit(0U);     // INRQ
constexpr std::uint32_t sleep = bit(1U);          // SLEEP
constexpr std::uint32_t by_request = bit(2U);     // TXFP: 1 sends in order of requests, 0 by identifier
constexpr std::uint32_t lock_fifo = bit(3U);      // RFLM: a full FIFO keeps its frames and drops new ones
constexpr std::uint32_t no_retry = bit(4U);       // NART
constexpr std::uint32_t leave_bus_off = bit(6U);  // ABOM
constexpr std::uint32_t time_stamps = bit(7U);    // TTCM
constexpr std::uint32_t reset = bit(15U);         // RESET
}  // namespace mcr

namespace msr {
constexpr std::uint32_t initialising = bit(0U);  // INAK
constexpr std::uint32_t asleep = bit(1U);        // SLAK
}  // namespace msr

/// Bits of mailbox 0. The bits of mailbox n are 8 * n positions higher; only `empty` is n positions higher.
namespace tsr {
constexpr std::uint32_t completed = bit(0U);  // RQCP0
constexpr std::uint32_t sent = bit(1U);       // TXOK0
constexpr std::uint32_t abort = bit(7U);      // ABRQ0
constexpr std::uint32_t empty = bit(26U);     // TME0
constexpr std::uint32_t stride = 8U;
}  // namespace tsr

namespace rfr {
constexpr std::uint32_t pending = 0x3U;     // FMP
constexpr std::uint32_t full = bit(3U);     // FULL
constexpr std::uint32_t overrun = bit(4U);  // FOVR
constexpr std::uint32_t release = bit(5U);  // RFOM
}  // namespace rfr

namespace ier {
constexpr std::uint32_t pending_0 = bit(1U);  // FMPIE0
constexpr std::uint32_t pending_1 = bit(4U);  // FMPIE1
}  // namespace ier

namespace esr {
constexpr std::uint32_t warning = bit(0U);  // EWGF
constexpr std::uint32_t passive = bit(1U);  // EPVF
constexpr std::uint32_t bus_off = bit(2U);  // BOFF
}  // namespace esr

/// Bits of the identifier registers of mailboxes; except for `request`, also of 32-bit filter banks.
namespace ir {
constexpr std::uint32_t request = bit(0U);   // TXRQ
constexpr std::uint32_t remote = bit(1U);    // RTR
constexpr std::uint32_t extended = bit(2U);  // IDE
constexpr std::uint32_t extended_shift = 3U;
constexpr std::uint32_t standard_shift = 21U;
}  // namespace ir

namespace dtr {
constexpr std::uint32_t length = 0xFU;  // DLC
constexpr std::uint32_t time_shift = 16U;
}  // namespace dtr

constexpr std::uint32_t filter_initialise = bit(0U);  // FINIT of CAN_FMR

}  // namespace canproof::stm32f405
