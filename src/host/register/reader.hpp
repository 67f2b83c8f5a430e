// SPDX-License-Identifier: Apache-2.0
// Reads the register from its files.
#pragma once

#include "host/register/fault.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// Reads all files and adds a fault for everything unreadable. References between items are not checked.
Register read_register(const SpecFiles& files, Faults& faults);

}  // namespace canproof::host
