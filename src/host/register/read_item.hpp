// What every item of the register has.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// The id, which must have the form of one.
void read_id(TomlItem& item, Item& into);
/// text and source as every item has them; `text_required` for those that consist of a sentence.
void read_common(TomlItem& item, Item& into, bool text_required);

}  // namespace canproof::host
