// SPDX-License-Identifier: Apache-2.0
// A checksum of a node's settings, compared after each computation of the device, so that a setting that changes while
// the device computes is noticed before an output or a frame leaves.
#pragma once

#include "firmware/canopen/node.hpp"

namespace canproof::stm32f405 {

/// The settings are the values that change only when a client writes them or when the node loads them. The node counts
/// these changes. StateGuard explains the checksum.
class SettingsGuard {
  public:
    /// Keeps the checksum of the settings after power-on.
    void keep(const NodeSettings& settings) noexcept;
    /// Returns whether the settings have the checksum that was kept, or the node has changed a setting since then.
    /// Keeps the present checksum.
    bool follow(const NodeSettings& settings) noexcept;

  private:
    std::uint32_t changes_{0U};
    std::uint32_t complement_{0U};
};

}  // namespace canproof::stm32f405
