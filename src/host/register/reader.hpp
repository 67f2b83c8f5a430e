// SPDX-License-Identifier: Apache-2.0
// Reads the register from its files.
#pragma once

#include "host/register/fault.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// Reads all files. Adds a fault for everything that cannot be read. Does not check references between items.
Register read_register(const SpecFiles& files, Faults& faults);

}  // namespace canproof::host
