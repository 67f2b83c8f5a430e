// SPDX-License-Identifier: Apache-2.0
// The errors of a device, from its tables of errors.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

struct ErrorRow {
    std::string table;  ///< id of the table
    std::string error;  ///< the error's name in the table
    std::string code;   ///< emergency code: `8130h`
    /// the name and the value of each further column; for a word of an enumeration, the value also has its number
    std::vector<std::pair<std::string, std::string>> others;
};

/// Returns all rows of the device's tables of errors, in the order of the register.
std::vector<ErrorRow> errors_of(const Register& content, const Part& part);

}  // namespace canproof::host
