// Check of the statements of the manuals.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Each statement stands at a place of its manual, each mark once in a manual, and what covers a statement is an item
/// in force: of a device with that manual, or shared.
void check_statements(const Register& content, Faults& faults);

}  // namespace canproof::host
