// SPDX-License-Identifier: Apache-2.0
// Determines the lengths of strings.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Sets the length of each string without `length` to the length of its default.
void resolve_lengths(Part& part);

}  // namespace canproof::host
