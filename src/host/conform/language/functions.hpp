// SPDX-License-Identifier: Apache-2.0
// The functions that an expression in a conformance case may call.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/conform/language/value.hpp"

namespace canproof::host::conform {

struct LanguageFunction {
    std::string name;
    std::size_t arguments;
    std::function<Value(const std::vector<Value>&)> call;
};

/// Returns the function with this name; nullptr when there is none.
const LanguageFunction* find_function(const std::string& name);
/// Returns the names of all functions for messages: `hex, crc, join, le …`.
std::string function_names();

/// Returns the CRC-16 of block transfer (CiA 301, 7.2.4.3.16): polynomial 1021h, start 0.
std::uint16_t block_crc(const Bytes& bytes);

}  // namespace canproof::host::conform
