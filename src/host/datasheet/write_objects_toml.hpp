// SPDX-License-Identifier: Apache-2.0
// Writes the objects of a data sheet as a file of the requirements register.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns TOML text with an [[object]] for each object of the device and its entries. `source` becomes the source of
/// each object.
std::string write_objects_toml(const Part& part, const std::string& source);

}  // namespace canproof::host
