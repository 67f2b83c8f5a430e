// SPDX-License-Identifier: Apache-2.0
// Point 1 of a lookup table of the AX130751 in data response: its X follows the minimum of the source while this
// minimum is below 0 (1.5.1).
#pragma once

#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "generated/ax130751/written.hpp"

namespace canproof::ax130751 {

/// The minimum of the last source that was asked for, and the X of a point 1 that lies there. Often all tables have the
/// same source, whose minimum is then computed once.
struct LastMinimum {
    SourceRef ref{};        ///< the source; quantity none: no minimum yet
    double value{0.0};      ///< the minimum of `ref`, in the unit of the source
    bool is_placed{false};  ///< whether `digits` and `x` are valid
    std::uint8_t digits{0U};
    std::int32_t x{0};

    /// Returns the X for the minimum with these decimal digits, rounded so that it is not below the minimum.
    std::int32_t place(std::uint8_t digits_of_x) noexcept;
};

/// Point 1 of one table. `last` passes the minimum on from table to table: make a new one for each write, and for each
/// load of the parameters.
class FirstPoint {
  public:
    /// Prepares follow() for table `number` (1…10) after its parameters were loaded; point 1 stays where it is.
    void begin(std::uint8_t number, const ObjectDictionary& objects, const Sources& sources,
               LastMinimum& last) noexcept;
    /// Moves point 1 after a write if the minimum of the source changed. Returns true when it moved. A point 1 that the
    /// user has set to another value stays, and so does one that would move above point 2.
    bool follow(std::uint8_t number, const generated::ax130751::Written& change, ObjectDictionary& objects,
                const Sources& sources, LastMinimum& last) noexcept;

  private:
    std::int32_t place_of(std::uint8_t number, const ObjectDictionary& objects, const Sources& sources,
                          LastMinimum& last) noexcept;

    SourceChoice source_{};
    /// The X that was computed from the last minimum of the source. It depends on the parameters that moves_point()
    /// names.
    std::int32_t x_{0};
};

}  // namespace canproof::ax130751
