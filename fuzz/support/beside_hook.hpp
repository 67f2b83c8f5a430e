// SPDX-License-Identifier: Apache-2.0
// Connects a fuzz target with the naive model of its device (a second, simple implementation). Programs for the
// microcontroller have no model.
#pragma once

#include <cstddef>
#include <cstdint>

namespace canproof::fuzz {

/// Runs an input beside the naive model of the device (beside_model.hpp). NAME_model.cpp of the device sets this
/// pointer.
inline void (*beside_model)(const std::uint8_t* data, std::size_t size){nullptr};

/// One of this many inputs also runs beside the model; the hash of the input decides. A replay runs all inputs beside
/// the model.
inline unsigned compared_one_in{8};

}  // namespace canproof::fuzz
