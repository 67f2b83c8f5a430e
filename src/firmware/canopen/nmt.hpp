// SPDX-License-Identifier: Apache-2.0
// NMT: the commands of the master, and which services work in which state (CiA 301, 7.2.8 and 7.3.2).
#pragma once

#include <optional>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/vocabulary.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof {

/// The services whose use depends on the NMT state.
using NmtService = generated::canopen::nmt_services::Service;

/// The services that work in one state (table CO-T-SERVICES), looked up once when the state is entered.
class AllowedServices {
  public:
    /// Creates the set for a state in which no service works.
    constexpr AllowedServices() noexcept = default;
    explicit AllowedServices(NmtState state) noexcept;

    bool has(const NmtService service) const noexcept {
        return ((bits_ >> static_cast<std::uint32_t>(service)) & 1U) != 0U;
    }

  private:
    std::uint32_t bits_{0U};
};

/// Returns the NMT command of `frame` for this node. Such a frame is a data frame with the 11-bit identifier 0 and
/// exactly two bytes: a defined command, and node-ID 0 (all nodes) or `node_id`. Returns nothing for every other frame.
std::optional<NmtCommand> nmt_command(const Frame& frame, std::uint8_t node_id) noexcept;

}  // namespace canproof
