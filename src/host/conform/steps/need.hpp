// SPDX-License-Identifier: Apache-2.0
// A condition that a slave must meet for a case to apply.
#pragma once

#include <functional>
#include <string>

#include "host/conform/language/scanner.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

struct Need {
    std::string words;  ///< as written
    /// Returns the reason why the need is not met; empty when it is met. May send requests to the slave.
    std::function<std::string(Context&)> unmet;
};

/// Parses a need. Throws LanguageError.
Need parse_need(Scanner& line);

}  // namespace canproof::host::conform
