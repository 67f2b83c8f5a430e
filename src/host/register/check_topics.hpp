// SPDX-License-Identifier: Apache-2.0
// Checks the answers of items to the same question, which is called a topic.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds a fault when two items answer the same topic differently:
/// - two items of one folder;
/// - an item of a device and an item of spec/canopen, unless the device gives a reason;
/// - items of two devices of the same manufacturer, unless one of them gives a reason.
/// Also adds a fault for an answer that differs from [services] in device.toml. If the register contains decisions of
/// devices, adds a fault for a reason without a difference, too. If it also has its own spec/canopen, adds a fault for
/// a topic with a single answer.
void check_topics(const Register& content, Faults& faults);

}  // namespace canproof::host
