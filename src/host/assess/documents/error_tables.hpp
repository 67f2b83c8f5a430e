// The errors of a device as its tables of errors list them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

struct ErrorRow {
    std::string table;                                        ///< id
    std::string error;                                        ///< the word
    std::string code;                                         ///< emergency code, `8130h`
    std::vector<std::pair<std::string, std::string>> others;  ///< column and value, words of enumerations with number
};

/// All rows of all tables of the part with `errors`, in the order of the register.
std::vector<ErrorRow> errors_of(const Register& content, const Part& part);

}  // namespace canproof::host
