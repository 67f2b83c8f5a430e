// SPDX-License-Identifier: Apache-2.0
// Constants, enumerations and signals as C++.
#pragma once

#include <string>

#include "host/codegen/cpp_text.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

std::string write_constants(const Part& part, Cells cells = Cells::constant);
std::string write_enumerations(const Part& part);
std::string write_signals(const Part& part);

}  // namespace canproof::host
