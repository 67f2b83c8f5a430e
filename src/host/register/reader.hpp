// TOML to structs. What cannot be read is told as a fault; what can be is read all the same, so that one run tells
// everything.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

Register read_register(const SpecFiles& files, Faults& faults);

/// One [[object]]: a list, because `repeat` makes one for each n.
std::vector<Object> read_objects(TomlItem& item, const std::string& prefix);
Table read_table(TomlItem& item);

void read_id(TomlItem& item, Item& into);
/// text and source as every item has them; `text_required` for those that consist of a sentence.
void read_common(TomlItem& item, Item& into, bool text_required);

}  // namespace canproof::host
