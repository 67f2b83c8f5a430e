// SPDX-License-Identifier: Apache-2.0
// Checks the ids, sources, references and decisions of the requirements register.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in ids, sources, references and decisions of the whole register.
void check_references(const Register& content, Faults& faults);

}  // namespace canproof::host
