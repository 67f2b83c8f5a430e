// SPDX-License-Identifier: Apache-2.0
// Counts the events that a fuzz target compares with the naive model of its device, and, by reason, the events that it
// leaves out.
#pragma once

#include <map>
#include <string>

namespace canproof::fuzz {

struct ModelCounts {
    unsigned long events{0};                        ///< events that both the device and the model got
    std::map<std::string, unsigned long> left_out;  ///< events that neither of them got, by reason
    std::map<std::string, unsigned long> ended;     ///< inputs whose comparison ended early, by reason
};

inline ModelCounts model_counts;

}  // namespace canproof::fuzz
