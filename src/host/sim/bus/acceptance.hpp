// SPDX-License-Identifier: Apache-2.0
// Acceptance filters: the identifiers that the kernel filters of a node let through.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::host {

/// Accepts a frame whose identifier equals `id` in the bits of `mask`. Remote frames are treated as data frames.
struct AcceptanceFilter {
    std::uint32_t id{0U};
    std::uint32_t mask{0x7FFU};
    bool extended{false};

    bool accepts(const Frame& frame) const { return frame.extended == extended && (frame.id & mask) == (id & mask); }
};

inline bool operator==(const AcceptanceFilter& a, const AcceptanceFilter& b) {
    return a.id == b.id && a.mask == b.mask && a.extended == b.extended;
}

/// Returns two filters that accept every frame, one for base and one for extended identifiers.
const std::vector<AcceptanceFilter>& accept_everything();

/// Returns the filters for the present COB-IDs in a dictionary: NMT, LSS, SYNC, TIME, SDO servers, PDOs (a transmit PDO
/// for its RTR), and error control of the node and of the nodes that it monitors. Without a node-ID, only NMT and LSS.
std::vector<AcceptanceFilter> acceptance_filters(const ObjectDictionary& objects, std::uint8_t node_id);

}  // namespace canproof::host
