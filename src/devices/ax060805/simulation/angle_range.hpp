// SPDX-License-Identifier: Apache-2.0
// The angle configuration of an AX060805 (3.5, Table 8). No object sets it; it is a factory setting of the unit.
#pragma once

#include <array>
#include <string>

#include "devices/ax060805/firmware/ax060805.hpp"

namespace canproof::ax060805 {

struct AngleRange {
    const char* word;  ///< name of the range in the manual's Table 8, without "Degree Range"
    AngleConfiguration range;
};

inline constexpr const char* angle_range_key = "angle_range";
inline constexpr std::array<AngleRange, 3> angle_ranges{{{"180", AngleConfiguration::half_turns},
                                                         {"360", AngleConfiguration::full_turn},
                                                         {"90", AngleConfiguration::right_angle}}};

}  // namespace canproof::ax060805
