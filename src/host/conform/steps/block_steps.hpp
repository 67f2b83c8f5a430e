// SPDX-License-Identifier: Apache-2.0
// The steps of a conformance case that begin with `block read` and `block write`.
#pragma once

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

/// Parses the rest of a line after the word `block`. `any` is true when the line begins with `try`, which accepts any
/// result of the transfer.
Action parse_block(Scanner& line, bool any);

}  // namespace canproof::host::conform
