// SPDX-License-Identifier: Apache-2.0
// Finds the receivers of a frame by its identifier. For filters of a single identifier, the effort does not depend on
// the number of nodes.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/acceptance.hpp"

namespace canproof::host {

/// A map from frames to readers. A reader is a number that the owner of the map chooses. A hash table contains the
/// filters for one identifier; filters for several identifiers are compared with each frame.
class FrameReaders {
  public:
    /// Sets the filters of `reader` and replaces its former ones. An empty list removes the reader.
    void set(std::size_t reader, const std::vector<AcceptanceFilter>& filters);
    /// Returns the readers of this frame, each once, in ascending order.
    std::vector<std::size_t> of(const Frame& frame) const;

    /// Returns the number of filters that of() compares with each frame.
    std::size_t compared() const { return wide_.size(); }
    /// Returns the number of readers that have filters, plus the number of identifiers that have readers.
    std::size_t kept() const { return filters_.size() + by_identifier_.size(); }

  private:
    struct Wide {
        std::size_t reader;
        AcceptanceFilter filter;
    };

    void remove(std::size_t reader);

    std::unordered_map<std::size_t, std::vector<AcceptanceFilter>> filters_;     ///< filters by reader
    std::unordered_map<std::uint32_t, std::vector<std::size_t>> by_identifier_;  ///< readers by key_of()
    std::vector<Wide> wide_;                                                     ///< filters for several identifiers
};

}  // namespace canproof::host
