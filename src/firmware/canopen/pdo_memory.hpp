// SPDX-License-Identifier: Apache-2.0
// The memory of a node's PDOs. The device owns it; its dictionary determines the size.
#pragma once

#include <array>

#include "firmware/canopen/receive_pdo.hpp"
#include "firmware/canopen/transmit_pdo.hpp"

namespace canproof {

/// The views through which a node uses the memory of its PDOs.
struct PdoMemory {
    Slots<ReceivePdo> received{};
    Slots<TransmitPdo> sent{};
    Slots<PdoLine> received_lines{};  ///< the lines of all receive PDOs, the same number for each
    Slots<PdoLine> sent_lines{};      ///< the lines of all transmit PDOs, the same number for each
};

/// Memory for `received` RPDOs and `sent` TPDOs with at most `lines` mapped entries each. The numbers are pdo_count()
/// and pdo_lines() of the dictionary.
template <std::size_t received, std::size_t sent, std::size_t lines>
struct SizedPdoMemory {
    std::array<ReceivePdo, received> received_pdos{};
    std::array<TransmitPdo, sent> sent_pdos{};
    std::array<PdoLine, received * lines> received_lines{};
    std::array<PdoLine, sent * lines> sent_lines{};

    PdoMemory memory() noexcept {
        return PdoMemory{Slots<ReceivePdo>{received_pdos}, Slots<TransmitPdo>{sent_pdos},
                         Slots<PdoLine>{received_lines}, Slots<PdoLine>{sent_lines}};
    }
};

/// The memory of the PDOs for a dictionary that is known at compile time.
template <const DictionaryTables& tables>
using PdoMemoryFor = SizedPdoMemory<pdo_count(tables, PdoDirection::receive), pdo_count(tables, PdoDirection::transmit),
                                    pdo_lines(tables)>;

}  // namespace canproof
