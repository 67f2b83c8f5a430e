// What the PDOs of a node take in RAM, sized by its dictionary: a device with four PDOs of four values does not pay for
// the eight of 64 bits that CiA 301 allows.
#pragma once

#include "firmware/canopen/receive_pdo.hpp"
#include "firmware/canopen/transmit_pdo.hpp"

namespace canproof {

/// The memory that a device lends to the PDOs of its node; it outlives the node.
struct PdoMemory {
    MutableTable<ReceivePdos::Rpdo> receive;
    MutableTable<PdoMapping::Line> receive_lines;  ///< of their mappings
    MutableTable<TransmitPdos::Tpdo> transmit;
    MutableTable<PdoMapping::Line> transmit_lines;
};

/// Such memory for a dictionary that is known when the device is compiled.
template <const DictionaryTables& Tables>
class PdoMemoryFor {
  public:
    PdoMemory memory() noexcept {
        return PdoMemory{mutable_table(receive_), mutable_table(receive_lines_), mutable_table(transmit_),
                         mutable_table(transmit_lines_)};
    }

  private:
    std::array<ReceivePdos::Rpdo, count_pdos(Tables, PdoDirection::receive)> receive_{};
    std::array<PdoMapping::Line, count_mapping_lines(Tables, PdoDirection::receive)> receive_lines_{};
    std::array<TransmitPdos::Tpdo, count_pdos(Tables, PdoDirection::transmit)> transmit_{};
    std::array<PdoMapping::Line, count_mapping_lines(Tables, PdoDirection::transmit)> transmit_lines_{};
};

}  // namespace canproof
