// SPDX-License-Identifier: Apache-2.0
// Connects a fuzz target with the naive model of its device (a second, simple implementation), and says how often a
// target does its expensive checks. Programs for the microcontroller have no model.
#pragma once

#include <cstddef>
#include <cstdint>

namespace canproof::fuzz {

/// Runs an input beside the naive model of the device (beside_model.hpp). NAME_model.cpp of the device sets this
/// pointer.
inline void (*beside_model)(const std::uint8_t* data, std::size_t size){nullptr};

/// How often a fuzz target does the checks that cost more than the run itself. The hash of an input decides, so that an
/// input always gets the same checks. A replay does all checks for every input.
struct Samples {
    unsigned compared_one_in{32};  ///< inputs that also run beside the model
    unsigned repeated_one_in{8};   ///< inputs that run a second time, with a check of the reset at the end
    unsigned checked_one_in{8};    ///< inputs with a check of the services' invariants after each step
    unsigned whole_one_in{32};     ///< inputs of `parameter_store` that also run with the whole conformance slave

    /// Makes every input get every check.
    void take_all() { compared_one_in = repeated_one_in = checked_one_in = whole_one_in = 1; }
    bool is_compared(std::uint64_t hash) const { return hash % compared_one_in == 0; }
    bool is_repeated(std::uint64_t hash) const { return (hash >> 32U) % repeated_one_in == 0; }
    bool is_whole(std::uint64_t hash) const { return (hash >> 40U) % whole_one_in == 0; }
    bool is_checked(std::uint64_t hash) const { return (hash >> 16U) % checked_one_in == 0; }
};

inline Samples samples;

}  // namespace canproof::fuzz
