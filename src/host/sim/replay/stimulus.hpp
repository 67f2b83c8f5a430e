// SPDX-License-Identifier: Apache-2.0
// Stimuli as CSV `seconds,signal,value`, with one change of a physical input per line.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

struct Stimulus {
    std::string where;  ///< file:line
    Instant time{};
    std::string signal;
    double value{0.0};
};

/// Reads all lines in ascending time. A first line `seconds,signal,value` is a header. Throws InputError with file and
/// line.
std::vector<Stimulus> read_stimuli(std::istream& in, const std::string& name);

/// Checks each stimulus. Throws InputError for a signal that none of these devices has as input, and for a value
/// outside the range or type of any device that has it.
void check_stimuli(const std::vector<Stimulus>& stimuli, const std::vector<const Part*>& devices);

}  // namespace canproof::host
