// SPDX-License-Identifier: Apache-2.0
// The registers of a CAN controller of the Zynq UltraScale+ (UG1085 chapter 20). UG1087 (revision 1.11) has no section
// numbers: its module CAN describes each register under the abbreviated name that is written beside the register here.
#pragma once

#include "target/stm32f405/register.hpp"

namespace canproof::zynqmp {

using stm32f405::bit;
using stm32f405::Register;

constexpr std::size_t filter_count = 4U;
/// Depth of TXFIFO and RXFIFO in frames (UG1085, "RX Messages").
constexpr std::size_t fifo_depth = 64U;

/// A frame in four words. Software has to write, or to read, all four in this order, whatever the length is (UG1085,
/// "Message Format").
struct FrameRegisters {
    Register identifier;  ///< TXFIFO_ID, TXHPB_ID, RXFIFO_ID
    Register length;      ///< TXFIFO_DLC, TXHPB_DLC, RXFIFO_DLC
    Register data_1;      ///< TXFIFO_DATA1, TXHPB_DATA1, RXFIFO_DATA1: bytes 0 to 3, byte 0 in the highest bits
    Register data_2;      ///< TXFIFO_DATA2, TXHPB_DATA2, RXFIFO_DATA2: bytes 4 to 7
};

struct Filter {
    Register mask;        ///< AFMR1 to AFMR4
    Register identifier;  ///< AFIR1 to AFIR4
};

struct CanRegisters {
    Register software_reset;                   ///< 00h SRR
    Register mode;                             ///< 04h MSR
    Register prescaler;                        ///< 08h BRPR
    Register bit_timing;                       ///< 0Ch BTR
    Register error_counters;                   ///< 10h ECR
    Register error_status;                     ///< 14h ESR
    Register status;                           ///< 18h SR
    Register interrupt_status;                 ///< 1Ch ISR
    Register interrupt_enable;                 ///< 20h IER
    Register interrupt_clear;                  ///< 24h ICR: a written 1 clears the bit of ISR
    Register time_stamp;                       ///< 28h TCR
    Register watermarks;                       ///< 2Ch WIR
    FrameRegisters transmit_fifo;              ///< 30h TXFIFO
    FrameRegisters transmit_first;             ///< 40h TXHPB, the buffer that is sent before the FIFO
    FrameRegisters receive_fifo;               ///< 50h RXFIFO
    Register filters_used;                     ///< 60h AFR
    std::array<Filter, filter_count> filters;  ///< 64h AFMR1 to 80h AFIR4
};

static_assert(sizeof(CanRegisters) == 0x84U, "AFIR4 lies at 80h");

namespace srr {
constexpr std::uint32_t reset = bit(0U);   // SRST
constexpr std::uint32_t enable = bit(1U);  // CEN: 0 selects the configuration mode
}  // namespace srr

namespace sr {
constexpr std::uint32_t configuration = bit(0U);     // CONFIG
constexpr std::uint32_t normal = bit(3U);            // NORMAL
constexpr std::uint32_t warning = bit(6U);           // ERRWRN
constexpr std::uint32_t error_state = 0x3U << 7U;    // ESTAT
constexpr std::uint32_t bus_off = 0x2U << 7U;        // ESTAT: 2
constexpr std::uint32_t error_passive = 0x3U << 7U;  // ESTAT: 3
constexpr std::uint32_t first_full = bit(9U);        // TXBFLL
constexpr std::uint32_t filters_busy = bit(11U);     // ACFBSY
}  // namespace sr

/// Bits of ISR, IER and ICR.
namespace isr {
constexpr std::uint32_t overrun = bit(6U);    // RXOFLW
constexpr std::uint32_t not_empty = bit(7U);  // RXNEMP
}  // namespace isr

/// Bits of the identifier words, and of the filters.
namespace idr {
constexpr std::uint32_t remote_extended = bit(0U);  // RTR: a remote frame with a 29-bit identifier
constexpr std::uint32_t low_shift = 1U;             // IDL
constexpr std::uint32_t low_bits = 18U;
constexpr std::uint32_t low_mask = 0x3FFFFU;
constexpr std::uint32_t extended = bit(19U);         // IDE
constexpr std::uint32_t remote_standard = bit(20U);  // SRRRTR: a remote frame with 11 bits; always 1 with 29 bits
constexpr std::uint32_t high_shift = 21U;            // IDH: the 11-bit identifier, or the upper 11 of 29 bits
}  // namespace idr

constexpr std::uint32_t length_shift = 28U;  // DLC

}  // namespace canproof::zynqmp
