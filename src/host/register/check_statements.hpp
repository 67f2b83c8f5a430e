// SPDX-License-Identifier: Apache-2.0
// Checks the statements of the manuals.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of the statements. Each statement must belong to a place of its manual, and each passage mark (hash
/// of a passage) must occur only once in a manual. The items in `covered` must not be retired, and must belong to a
/// device with that manual or to the shared rules (spec/canopen).
void check_statements(const Register& content, Faults& faults);

}  // namespace canproof::host
