// SPDX-License-Identifier: Apache-2.0
// Warnings about a requirements register that has no faults but could be better.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the warnings, ascending by file and line. None of them prevents a build:
/// - a statement with neither `covered` nor `reason`, which the audit reports as a gap;
/// - a statement when none of its covering items names the statement's place, or a section above or below it, as
/// source;
/// - a requirement of this project in force that demands several things: with several "shall", or several sentences.
Faults advice_on(const Register& content);

}  // namespace canproof::host
