// Lookup tables (1.5), logic blocks (1.6) and math blocks (1.7) of the AX130751, each wired to its objects.
#pragma once

#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "devices/ax130751/firmware/logic_block.hpp"
#include "devices/ax130751/firmware/lookup_table.hpp"
#include "devices/ax130751/firmware/math_block.hpp"

namespace canproof::ax130751 {

/// One lookup table.
class TableBlock {
  public:
    void reset() noexcept {
        table_.reset();
        is_read_ = false;
    }
    /// Its parameters are others than they were.
    void reread() noexcept { is_read_ = false; }
    /// Evaluates table `number` (1…10), sets 3yz8h and what other blocks see. True while it goes on changing.
    bool advance(std::uint8_t number, ObjectDictionary& objects, Sources& sources, Instant now) noexcept;

  private:
    SourceChoice source_{};
    LookupTable table_{};
    // Keys of this cache: 3yz2h to 3yz7h of the table. Each write to one, and each move of point 1, ends in reread().
    LookupConfig config_{};  ///< as last read
    LookupLimits limits_{};  ///< of its output, for other blocks
    bool is_read_{false};
    SignalState state_{SignalState::not_available};
};

/// Whether table `number` is over time (3yz5h:1).
bool is_over_time(const ObjectDictionary& objects, std::uint8_t number) noexcept;
/// What the choice of time response sets: point 1 and the digits of X.
void begin_time_response(ObjectDictionary& objects, std::uint8_t number) noexcept;
/// Whether point `point` (1…11) of table `number` may lie at `x`.
AbortCode check_point(const ObjectDictionary& objects, const Sources& sources, std::uint8_t number, std::uint8_t point,
                      std::int32_t x) noexcept;

/// One logic block.
class SelectionBlock {
  public:
    /// Evaluates logic block `number` (1…3), sets 3310h, 3320h and what other blocks see. True when it selects another
    /// table; while it does not, its output changes only where that of a table does, which tells so itself.
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
    /// Evaluates math block `number` (1…4) and sets 4030h. True while its functions give other results than before.
    bool advance(std::uint8_t number, ObjectDictionary& objects, const Sources& sources) noexcept;

  private:
    MathInput read(std::uint8_t number, std::uint8_t input, const ObjectDictionary& objects,
                   const Sources& sources) noexcept;

    /// An input, and what its parameters came to when they were last others. Keys of this cache: source and number,
    /// each scaling and the digits, and the gain in `gain_parameter`.
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
