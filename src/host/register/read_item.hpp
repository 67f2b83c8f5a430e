// SPDX-License-Identifier: Apache-2.0
// Reads the fields that every item of the register has.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Reads the id of an item and checks its form.
void read_id(TomlItem& item, Item& into);
/// Reads the fields `text` and `source`. If `text_required`, an item without text is a fault.
void read_common(TomlItem& item, Item& into, bool text_required);

}  // namespace canproof::host
