// SPDX-License-Identifier: Apache-2.0
// Checks the default mapping of each PDO against the objects that it maps.
#pragma once

#include "host/register/fault.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Adds a fault for each default of a PDO mapping that names no entry, an entry that may not be in such a PDO, or the
/// wrong number of bits.
void check_mappings(const Part& part, Faults& faults);

}  // namespace canproof::host
