// A text as a TOML file holds it.
#pragma once

#include <string>

namespace canproof::host {

/// Returns the text as a basic string of TOML, with its quotation marks; control characters become \uXXXX.
std::string toml_string(const std::string& text);

}  // namespace canproof::host
