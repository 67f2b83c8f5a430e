// Stimuli: CSV `seconds,signal,value`, one change of a physical input a line.
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

/// All lines in ascending time; throws InputError with file and line. A first line `seconds,signal,value` is a heading.
std::vector<Stimulus> read_stimuli(std::istream& in, const std::string& name);

/// Throws InputError for a signal that is no input of any of these devices, or a value outside its range or
/// type on any of those that have it.
void check_stimuli(const std::vector<Stimulus>& stimuli, const std::vector<const Part*>& devices);

}  // namespace canproof::host
