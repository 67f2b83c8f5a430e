// What must hold between the items of the register. Each check adds its faults; none stops at the first.
#pragma once

#include "host/speccompiler/register.hpp"

namespace canproof::host {

/// Ids, sources, references and decisions of the whole register.
void check_references(const Register& content, Faults& faults);
/// Types, defaults, limits and sub-indices of one part's objects. Ranges that name a table get their values here.
void check_objects(Part& part, Faults& faults);
/// Domains, gaps and overlaps of decision tables; types of constants, enumerations and signals.
void check_tables(const Register& content, Part& part, Faults& faults);
void check_literals(const Register& content, Part& part, Faults& faults);

}  // namespace canproof::host
