// SPDX-License-Identifier: Apache-2.0
// Reads the fields that every item of the register has.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Reads the id of an item and the place of the id. check_references() checks the form of the id.
void read_id(TomlItem& item, Item& into);
/// Reads the fields `text`, `source`, `derived` and `reason`. If `text_required`, an item without text is a fault. An
/// item without a source is a fault unless it is derived; a derived item needs a reason.
void read_common(TomlItem& item, Item& into, bool text_required);

}  // namespace canproof::host
