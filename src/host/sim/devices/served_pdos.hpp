// Which PDOs of a data sheet a node here serves.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Throws InputError when a PDO of `part` is beyond those that a node serves, and names each by its place, number and
/// index. Its objects would be there, and no frame would ever follow from them. The firmware serves PDO1 to PDO8 of
/// each direction (max_pdos); CiA 301 has room for 512.
void check_served_pdos(const Part& part);

}  // namespace canproof::host
