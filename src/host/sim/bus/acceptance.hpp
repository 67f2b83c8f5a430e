// Which identifiers a node listens to: what its kernel filters let through.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::host {

/// Accepts a frame whose identifier equals `id` in the bits of `mask`. Remote frames pass as data frames do.
struct AcceptanceFilter {
    std::uint32_t id{0U};
    std::uint32_t mask{0x7FFU};
    bool extended{false};

    bool accepts(const Frame& frame) const { return frame.extended == extended && (frame.id & mask) == (id & mask); }
};

inline bool operator==(const AcceptanceFilter& a, const AcceptanceFilter& b) {
    return a.id == b.id && a.mask == b.mask && a.extended == b.extended;
}

/// A filter that lets every frame through, and its extended twin.
const std::vector<AcceptanceFilter>& accept_everything();

/// By the COB-IDs that stand in a dictionary now: NMT, LSS, SYNC, TIME, the SDO servers, the PDOs (a transmit PDO for
/// its RTR), error control of the node and of those that it watches. Without a node-ID only NMT and LSS.
std::vector<AcceptanceFilter> acceptance_filters(const ObjectDictionary& objects, std::uint8_t node_id);

}  // namespace canproof::host
