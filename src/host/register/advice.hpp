// SPDX-License-Identifier: Apache-2.0
// Warnings about a requirements register that has no faults but could be better.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the warnings, ascending by file and line. None of them prevents a build:
/// - a statement with neither `covered` nor `reason`, which the audit reports as a gap;
/// - a statement, if none of the items that cover it names the statement's place in the manual, or a section above or
/// below this place, as its source;
/// - a requirement that is not retired and whose text has several "shall", several sentences or a second condition
/// behind a semicolon, unless the requirement comes with an installed canproof.
Faults advice_on(const Register& content);

}  // namespace canproof::host
