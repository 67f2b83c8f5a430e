// SPDX-License-Identifier: Apache-2.0
// Acceptance filters: they select by identifier the frames that a bus passes to a node.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::host {

/// Accepts a frame whose identifier is equal to `id` in the bits of `mask`. The filter does not distinguish remote
/// frames from data frames.
struct AcceptanceFilter {
    std::uint32_t id{0U};
    std::uint32_t mask{0x7FFU};
    bool extended{false};

    bool accepts(const Frame& frame) const { return frame.extended == extended && (frame.id & mask) == (id & mask); }
};

inline bool operator==(const AcceptanceFilter& a, const AcceptanceFilter& b) {
    return a.id == b.id && a.mask == b.mask && a.extended == b.extended;
}

/// Returns two filters that together accept every frame: one for 11-bit and one for 29-bit identifiers.
const std::vector<AcceptanceFilter>& accept_everything();

/// Returns filters for all frames to which a node with this dictionary reacts. These are NMT, LSS, SYNC, TIME, SDO
/// requests, PDOs (transmit PDOs because of their remote frames), and the error control of the node and of the nodes
/// that it monitors. If `node_id` is no node-ID, returns only the filters for NMT and LSS.
std::vector<AcceptanceFilter> acceptance_filters(const ObjectDictionary& objects, std::uint8_t node_id);

}  // namespace canproof::host
