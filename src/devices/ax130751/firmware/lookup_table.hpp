// Lookup tables of eleven points, over a value or over time (AX130751, 1.5).
#pragma once

#include <array>

#include "devices/ax130751/firmware/digital_reading.hpp"
#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

constexpr std::size_t lookup_points = 11U;

/// How a point is reached from the one before.
enum class PointResponse : std::uint8_t { ignore, ramp, jump };

/// `x` in the unit of the source, or the microseconds since the point before; `response` of the first point has no
/// meaning.
struct LookupPoints {
    std::array<double, lookup_points> x{};
    std::array<double, lookup_points> y{};
    std::array<PointResponse, lookup_points> response{};
};

/// y for x, where the x of the points rise or stay. A stretch between two points does not contain its lower end.
double lookup(double x, const LookupPoints& points) noexcept;

/// y after `running` of a profile whose x are intervals. With `repeat` rounds follow each other, each without its
/// start and with its end.
double lookup_in_time(Duration running, const LookupPoints& profile, bool repeat) noexcept;

/// The length of a profile: its intervals up to the first ignored point.
Duration profile_length(const LookupPoints& profile) noexcept;

/// The limits of y, over all points.
struct LookupLimits {
    double least{0.0};
    double greatest{0.0};
};
LookupLimits lookup_limits(const LookupPoints& points) noexcept;

enum class LookupAxis : std::uint8_t { data, time };

struct LookupConfig {
    LookupAxis axis{LookupAxis::data};
    bool repeat{false};
    LookupPoints points{};
};

struct LookupOutput {
    double value{0.0};
    SignalState state{SignalState::not_available};
};

class LookupTable {
  public:
    LookupOutput advance(const BlockSignal& input, const LookupConfig& config, Instant now) noexcept;
    /// Whether its profile runs: the output moves by itself.
    bool is_running() const noexcept { return running_; }
    void reset() noexcept { *this = LookupTable{}; }

  private:
    double follow_time(const BlockSignal& input, const LookupConfig& config, Instant now) noexcept;

    DigitalReading start_{};
    Instant started_{};
    double value_{0.0};
    bool under_way_{false};
    bool running_{false};
};

}  // namespace canproof::ax130751
