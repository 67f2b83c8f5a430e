// SPDX-License-Identifier: Apache-2.0
// A need: a condition that a slave must meet for a conformance case to apply.
#pragma once

#include <functional>
#include <string>

#include "host/conform/language/scanner.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

struct Need {
    std::string words;  ///< text of the need as written in the case
    /// Returns the reason why the need is not met; empty when it is met. May send requests to the slave.
    std::function<std::string(Context&)> unmet;
};

/// Parses a need: a condition that a slave must meet for a case to apply. Throws LanguageError.
Need parse_need(Scanner& line);

}  // namespace canproof::host::conform
