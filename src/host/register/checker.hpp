// What must hold between the items of the register. Each check adds its faults; none stops at the first.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Ids, sources, references and decisions of the whole register.
void check_references(const Register& content, Faults& faults);
/// Items that answer one question in two ways: in one folder, against a shared item, or in two devices of one maker.
void check_topics(const Register& content, Faults& faults);
/// Domains, gaps and overlaps of decision tables. Columns of an enumeration get its words.
void check_tables(const Register& content, Part& part, Faults& faults);
/// Types, names and values of constants, enumerations and signals.
void check_literals(const Part& part, Faults& faults);
/// Names that are written as C++, and what [services] says.
void check_names(const Part& part, Faults& faults);
/// Ranges that name a table get its values.
void resolve_ranges(const Register& content, Part& part, Faults& faults);
/// Strings without a length get that of their default.
void resolve_lengths(Part& part);
/// Types, defaults, limits and sub-indices of one part's objects.
void check_objects(const Part& part, Faults& faults);
/// The limits of one part's entries: the objects they name, their order, and the defaults within.
void check_limits(const Part& part, Faults& faults);

}  // namespace canproof::host
