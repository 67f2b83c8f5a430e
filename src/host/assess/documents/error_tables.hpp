// SPDX-License-Identifier: Apache-2.0
// The errors of a device, from its tables of errors.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

struct ErrorRow {
    std::string table;                                        ///< id of the table
    std::string error;                                        ///< word of the error
    std::string code;                                         ///< emergency code: `8130h`
    std::vector<std::pair<std::string, std::string>> others;  ///< other columns and values; words of enumerations have
                                                              ///< their number
};

/// Returns all rows of all tables of the part with `errors`, in the order of the register.
std::vector<ErrorRow> errors_of(const Register& content, const Part& part);

}  // namespace canproof::host
