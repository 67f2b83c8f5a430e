// SPDX-License-Identifier: Apache-2.0
// An object dictionary as C++ tables.
#pragma once

#include <string>

#include "host/codegen/cpp_text.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

std::string write_objects(const Part& part, Cells cells = Cells::constant);

}  // namespace canproof::host
