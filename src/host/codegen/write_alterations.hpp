// SPDX-License-Identifier: Apache-2.0
// The list of alterations for `canproof mutate`, as C++.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns one row for each alteration: item, cell, change, address, and the bytes that replace those at the address.
/// The rows fit code that was generated with changeable cells (values that a running program can alter).
std::string write_alterations(const Register& content);

}  // namespace canproof::host
