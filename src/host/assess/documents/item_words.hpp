// What an item of the register says beyond its text, as a sentence: the facts of an object, the value of a constant,
// the rows of a table.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Type, access, range, default, storage and mapping of one entry.
std::string entry_words(const Entry& entry);
/// Those of each entry; neighbours that agree stand together.
std::string object_words(const Object& object);
std::string constant_words(const Constant& constant);
std::string enumeration_words(const Enumeration& enumeration);
std::string table_words(const Table& table);
/// Direction, type, unit, range and default.
std::string signal_words(const Signal& signal);

/// The sentence of the item with this id of the part; empty for requirements and decisions, which say all themselves.
std::string item_words(const Part& part, const std::string& id);

/// One field of a table: `any`, `1 … 5`, `2 or 4`, `8110h`.
std::string cell_words(const Cell& cell);

}  // namespace canproof::host
