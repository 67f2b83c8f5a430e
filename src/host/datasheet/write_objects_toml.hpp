// SPDX-License-Identifier: Apache-2.0
// Writes the objects of a data sheet as a file of the requirements register.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns one [[object]] after the other with all entries of the part; each object has this `source`.
std::string write_objects_toml(const Part& part, const std::string& source);

}  // namespace canproof::host
