// What a write to an entry has changed, as C++.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// The objects of which a device hears when they are written, as an enumeration and a function that finds it.
std::string write_written(const Part& part);

}  // namespace canproof::host
