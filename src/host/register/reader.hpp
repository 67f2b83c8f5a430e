// The register out of its files.
#pragma once

#include "host/register/fault.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// Reads all files; what cannot be read is a fault. What the items say of each other is not checked.
Register read_register(const SpecFiles& files, Faults& faults);

}  // namespace canproof::host
