// SPDX-License-Identifier: Apache-2.0
// Stimuli in the CSV form `seconds,signal,value`. Each line changes one physical input.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

struct Stimulus {
    std::string where;  ///< place of the line as file:line
    Instant time{};
    std::string signal;
    double value{0.0};
};

/// Reads all lines, whose times must be ascending. The first line may be the header `seconds,signal,value`. Throws
/// InputError with file and line for any other text.
std::vector<Stimulus> read_stimuli(std::istream& in, const std::string& name);

/// Checks each stimulus. Throws InputError when none of the devices has an input with the name of its signal. Also
/// throws it when the value is outside the range or type of any device that has the input.
void check_stimuli(const std::vector<Stimulus>& stimuli, const std::vector<const Part*>& devices);

}  // namespace canproof::host
