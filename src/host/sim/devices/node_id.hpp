// The node-IDs that a device can be given from outside. No other number gets as far as a device.
#pragma once

#include <cstdint>
#include <string>

#include "generated/canopen/constants.hpp"

namespace canproof::host {

/// 1…127, or 255 for a device without a node-ID, which LSS can give it one.
class NodeId {
  public:
    static inline const int lowest = generated::canopen::lss_lowest_node_id;
    static inline const int highest = generated::canopen::lss_highest_node_id;
    static inline const int none = generated::canopen::unconfigured_node_id;

    static constexpr bool is_one(int number) { return (number >= lowest && number <= highest) || number == none; }

    /// Takes a number as it is. Throws InputError when it is none of those.
    NodeId(int number);

    std::uint8_t value() const { return value_; }

  private:
    std::uint8_t value_;
};

/// What may be written for a node-ID, for messages.
std::string node_id_words();

}  // namespace canproof::host
