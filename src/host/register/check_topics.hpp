// SPDX-License-Identifier: Apache-2.0
// Checks the answers of items to the same question.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds a fault where two items answer the same question (topic) differently:
/// - two items of one folder;
/// - an item of a device and one of spec/canopen, when the device states no reason;
/// - items of two devices of the same manufacturer, when no reason is stated.
void check_topics(const Register& content, Faults& faults);

}  // namespace canproof::host
