// CiA 306: an electronic data sheet out of the register.
#pragma once

#include <string>

#include "host/datasheet/eds_values.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// CRLF line ends.
std::string write_eds(const Register& content, const Part& part, Reals reals = Reals::without_limits);

}  // namespace canproof::host
