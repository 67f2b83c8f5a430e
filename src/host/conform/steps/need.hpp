// What a slave must have for a case to apply.
#pragma once

#include <functional>
#include <string>

#include "host/conform/language/scanner.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

struct Need {
    std::string words;  ///< as written
    /// Why it is not met; empty when it is. May ask the slave.
    std::function<std::string(Context&)> unmet;
};

/// Throws LanguageError.
Need parse_need(Scanner& line);

}  // namespace canproof::host::conform
