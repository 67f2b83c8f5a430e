// Check of decision tables.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Domains, gaps and overlaps of decision tables. Columns of an enumeration get its words.
void check_tables(const Register& content, Part& part, Faults& faults);

}  // namespace canproof::host
