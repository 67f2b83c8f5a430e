// What is sound in a register and could be better.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Warnings, ascending by file and line. None of them hinders a build:
/// - a statement with neither `covered` nor `reason`, which the audit calls a gap;
/// - a statement of which no item that covers it cites its place in the manual;
/// - a requirement in force that asks for several things: more than one "shall", or several sentences.
Faults advice_on(const Register& content);

}  // namespace canproof::host
