// SPDX-License-Identifier: Apache-2.0
// Lookup tables (1.5), logic blocks (1.6) and math blocks (1.7) of the AX130751, each connected to its objects.
#pragma once

#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "devices/ax130751/firmware/logic_block.hpp"
#include "devices/ax130751/firmware/lookup_table.hpp"
#include "devices/ax130751/firmware/math_block.hpp"

namespace canproof::ax130751 {

/// One lookup table.
class TableBlock {
  public:
    /// Ends a running response and reads the parameters of table `number` (1…10).
    void reset(std::uint8_t number, const ObjectDictionary& objects) noexcept;
    /// Reads the parameters of table `number` (1…10), after a write to one of them. Does not leave this to the next
    /// cycle, because one cycle is too short to read several tables.
    void read(std::uint8_t number, const ObjectDictionary& objects) noexcept;
    /// Reads the values of Y of table `number` (1…10), after a write to one of them or to their decimal digits.
    void read_y(std::uint8_t number, const ObjectDictionary& objects) noexcept;
    /// Takes over the X of point 1, which the device has moved. One write can move point 1 of all tables, so this takes
    /// less time than read().
    void move_first_point(std::uint8_t number, const ObjectDictionary& objects) noexcept;
    /// Evaluates table `number` (1…10) and sets its output (3yz8h, output Y-axis process value) and the values that
    /// other blocks read. Returns true when the output or its state has changed, and while a time response runs.
    bool advance(std::uint8_t number, ObjectDictionary& objects, Sources& sources, Instant now) noexcept;

  private:
    SourceChoice source_{};
    LookupTable table_{};
    // This cache depends on the table's parameters 3yz2h to 3yz7h, where yz is the number of the table. Each write to
    // one of them calls read() or read_y(), and each move of point 1 calls move_first_point().
    LookupConfig config_{};  ///< the configuration as it was last read
    LookupLimits limits_{};  ///< limits of the table's output, for other blocks
    SignalState state_{SignalState::not_available};
};

/// Returns whether table `number` has a time response, which 3yz5h:1 (point response of point 1) selects.
bool is_over_time(const ObjectDictionary& objects, std::uint8_t number) noexcept;
/// Prepares table `number` (1…10) for the time response that was just selected: sets X and Y of point 1 and the digits
/// of X to 0.
void begin_time_response(ObjectDictionary& objects, std::uint8_t number) noexcept;
/// Returns AbortCode::none when point `point` (1…11) of table `number` (1…10) may have this `x`, otherwise the reason.
AbortCode check_point(const ObjectDictionary& objects, const Sources& sources, std::uint8_t number, std::uint8_t point,
                      std::int32_t x) noexcept;

/// One logic block.
class SelectionBlock {
  public:
    /// Evaluates logic block `number` (1…3) and sets 3310h selected table, 3320h output and the values that other
    /// blocks read. Returns true when it selects another table than before. Otherwise its output changes only with
    /// that of a table, which reports the change itself.
    bool advance(std::uint8_t number, ObjectDictionary& objects, Sources& sources) noexcept;

  private:
    struct Choices {
        SourceChoice first{};
        SourceChoice second{};
    };

    LogicFunction read(std::uint8_t number, std::size_t function, const ObjectDictionary& objects,
                       const Sources& sources) noexcept;

    std::array<Choices, logic_functions * logic_conditions> choices_{};
};

/// One math block.
class CalculationBlock {
  public:
    void reset() noexcept { math_.reset(); }
    /// Evaluates math block `number` (1…4) and sets 4030h math output process value. Returns true if the results of its
    /// functions have changed.
    bool advance(std::uint8_t number, ObjectDictionary& objects, const Sources& sources) noexcept;

  private:
    void read(std::uint8_t number, std::uint8_t input, const ObjectDictionary& objects, const Sources& sources,
              MathInput& made) noexcept;

    /// An input with the values computed from its parameters. This cache depends on source and number, each scaling and
    /// its digits, and the gain in `gain_parameter`.
    struct Input {
        SourceChoice choice{};
        KeptPhysicalValue scaling_1{};
        KeptPhysicalValue scaling_2{};
        double gain{0.0};
        std::int8_t gain_parameter{0};
    };

    std::array<Input, math_inputs> inputs_{};
    KeptPhysicalValue output_scaling_1_{};
    KeptPhysicalValue output_scaling_2_{};
    MathBlock math_{};
};

}  // namespace canproof::ax130751
