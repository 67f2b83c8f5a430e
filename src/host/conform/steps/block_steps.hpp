// The verbs `block read` and `block write`.
#pragma once

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

/// Behind the word `block`. `any`: behind `try`.
Action parse_block(Scanner& line, bool any);

}  // namespace canproof::host::conform
