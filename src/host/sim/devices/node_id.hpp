// SPDX-License-Identifier: Apache-2.0
// The node-IDs that a user can give to a device. Other numbers never reach a device.
#pragma once

#include <cstdint>
#include <string>

#include "generated/canopen/constants.hpp"

namespace canproof::host {

/// A number from 1 to 127, or 255 for a device without a node-ID, to which LSS can assign one.
class NodeId {
  public:
    static inline const int lowest = generated::canopen::lss_lowest_node_id;
    static inline const int highest = generated::canopen::lss_highest_node_id;
    static inline const int none = generated::canopen::unconfigured_node_id;

    static constexpr bool is_one(int number) { return (number >= lowest && number <= highest) || number == none; }

    /// Stores the number. Throws InputError unless it is 1 to 127 or 255.
    NodeId(int number);

    std::uint8_t value() const { return value_; }

  private:
    std::uint8_t value_;
};

/// Returns a description of the valid node-IDs for messages.
std::string node_id_words();

}  // namespace canproof::host
