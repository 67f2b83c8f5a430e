// SPDX-License-Identifier: Apache-2.0
// Reads the reviews in reviews.toml.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Reads one [[review]], and adds a review to `part` for each item that the [[review]] names. An item may have the
/// author's review and an earlier review by an independent reader; any other second review of an item is a fault.
void read_review(TomlItem& item, Part& part);

}  // namespace canproof::host
