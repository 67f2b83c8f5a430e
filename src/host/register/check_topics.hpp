// SPDX-License-Identifier: Apache-2.0
// Checks the answers of items to the same question, which is called a topic.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds a fault when two items answer the same topic differently:
/// - two items of one folder;
/// - an item of a device and an item of spec/canopen, unless the device gives a reason;
/// - items of two devices of the same manufacturer, unless one of them gives a reason.
/// Also adds a fault for a reason without a difference, for a topic with a single answer, and for an answer that
/// differs from [services] in device.toml.
void check_topics(const Register& content, Faults& faults);

}  // namespace canproof::host
