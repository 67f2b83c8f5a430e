// The list of alterations for `canproof mutate`, as C++.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// One row an alteration: requirement, cell, address, and the bytes that replace it. Fits what is written changeable.
std::string write_alterations(const Register& content);

}  // namespace canproof::host
