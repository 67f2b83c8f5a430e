// CiA 311: an XML device description out of the register.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

std::string write_xdd(const Register& content, const Part& part);

}  // namespace canproof::host
