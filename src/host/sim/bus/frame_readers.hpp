// Who reads which frame: a frame finds its receivers by its identifier, however many nodes there are.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/acceptance.hpp"

namespace canproof::host {

/// Readers are numbers that their owner gives. A filter for one identifier costs nothing when another identifier comes;
/// a filter for several is looked at for each frame.
class FrameReaders {
  public:
    /// From now on `reader` reads what one of `filters` lets through, and nothing else. An empty list removes it.
    void set(std::size_t reader, const std::vector<AcceptanceFilter>& filters);
    /// The readers of this frame, each once, in ascending order.
    std::vector<std::size_t> of(const Frame& frame) const;

  private:
    struct Wide {
        std::size_t reader;
        AcceptanceFilter filter;
    };

    void remove(std::size_t reader);

    std::unordered_map<std::size_t, std::vector<AcceptanceFilter>> filters_;     ///< by reader
    std::unordered_map<std::uint32_t, std::vector<std::size_t>> by_identifier_;  ///< by key_of()
    std::vector<Wide> wide_;                                                     ///< filters for several identifiers
};

}  // namespace canproof::host
