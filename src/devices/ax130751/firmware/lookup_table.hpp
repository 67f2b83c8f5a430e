// SPDX-License-Identifier: Apache-2.0
// Lookup tables of eleven points, over a value or over time (AX130751, 1.5).
#pragma once

#include <array>

#include "devices/ax130751/firmware/digital_reading.hpp"
#include "firmware/base/time.hpp"
#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

constexpr std::size_t lookup_points = 11U;

/// The response between a point and the one before it: `ramp` or `jump`. `ignore` ends the table at the point before
/// it. The other values occur for point 1 only (3yz5h:1), which selects the type of the X axis.
using PointResponse = generated::ax130751::point_response::Meaning;

/// The points of a table. `x` is in the unit of the source, or in microseconds since the start of the profile;
/// `response` of the first point has no meaning.
struct LookupPoints {
    std::array<double, lookup_points> x{};
    std::array<double, lookup_points> y{};
    std::array<PointResponse, lookup_points> response{};
};

/// Returns y for x; the x of the points must not decrease. Up to the first point, y is that of the first point. Beyond
/// the last point of the table, y is that of the last point, which is the one before the first ignored point. An
/// interval between two points excludes its lower end.
double lookup(double x, const LookupPoints& points) noexcept;

/// Returns a profile for points whose x are intervals: whole microseconds since the point before. The first point
/// starts the profile, whatever its x.
LookupPoints profile_of(const LookupPoints& intervals) noexcept;

/// Returns y of a profile at the time `running` after its start. With `repeat` the profile starts again after its end;
/// each round excludes its start time and includes its end time.
double lookup_in_time(Duration running, const LookupPoints& profile, bool repeat) noexcept;

/// Returns the length of a profile: the x of the last point before the first ignored one. The x are whole microseconds
/// from 0 to below 2^53.
Duration profile_length(const LookupPoints& profile) noexcept;

/// The range of y over all points, ignored ones included.
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
    /// Evaluates the table at `now`; call it in every cycle. The output has the state of `input`. While `input` is in
    /// error, a table over a value keeps its output value, and a table over time outputs 0.
    LookupOutput advance(const BlockSignal& input, const LookupConfig& config, Instant now) noexcept;
    /// Returns whether a profile runs, so that the output can change while the input does not change.
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
