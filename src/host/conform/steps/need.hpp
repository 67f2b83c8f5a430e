// SPDX-License-Identifier: Apache-2.0
// A condition (need) without which a conformance case does not apply to a slave.
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

/// Parses a need: a condition without which a case does not apply to a slave. Throws LanguageError.
Need parse_need(Scanner& line);

}  // namespace canproof::host::conform
