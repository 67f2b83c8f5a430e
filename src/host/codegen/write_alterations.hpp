// SPDX-License-Identifier: Apache-2.0
// The list of alterations for `canproof mutate`, as C++.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns one row per alteration: requirement, cell, address, and the replacing bytes. It matches code generated with
/// changeable cells.
std::string write_alterations(const Register& content);

}  // namespace canproof::host
