// Stimuli: CSV `seconds,signal,value`, one change of a physical input a line.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"

namespace canproof::host {

struct Stimulus {
    Instant time{};
    std::string signal;
    double value{0.0};
};

/// All lines in ascending time; throws InputError with file and line. A first line `seconds,signal,value` is a heading.
std::vector<Stimulus> read_stimuli(std::istream& in, const std::string& name);

}  // namespace canproof::host
