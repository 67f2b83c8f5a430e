// SPDX-License-Identifier: Apache-2.0
// Checks the answers of items to the same question.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds a fault for items that answer one question differently without a reason: in one folder, against a shared item,
/// or in two devices of the same manufacturer.
void check_topics(const Register& content, Faults& faults);

}  // namespace canproof::host
