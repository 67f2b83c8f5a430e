// Point 1 of a lookup table of the AX130751 in data response: its X goes along with the minimum of the source while
// that is below 0 (1.5.1).
#pragma once

#include "devices/ax130751/firmware/ax130751_sources.hpp"

namespace canproof::ax130751 {

class FirstPoint {
  public:
    /// Table `number` (1…10) has its parameters as they were loaded; point 1 stays where it is.
    void begin(std::uint8_t number, const ObjectDictionary& objects, const Sources& sources) noexcept;
    /// After a write to `entry`: true when it moved point 1. One that a user has put elsewhere stays, and so does one
    /// that would come to lie above point 2.
    bool follow(std::uint8_t number, const EntryRef& entry, ObjectDictionary& objects, const Sources& sources) noexcept;

  private:
    std::int32_t place_of(std::uint8_t number, const ObjectDictionary& objects, const Sources& sources) noexcept;

    SourceChoice source_{};
    /// Where the minimum of the source put it last. Keys: the entries of the table and those that moves_minimum()
    /// names.
    std::int32_t x_{0};
};

}  // namespace canproof::ax130751
