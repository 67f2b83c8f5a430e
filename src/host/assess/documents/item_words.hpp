// SPDX-License-Identifier: Apache-2.0
// Describes the data of an item in words: the facts of an object, the value of a constant, the rows of a table.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns type, access, range, default, storage and mapping of one entry.
std::string entry_words(const Entry& entry);
/// Describes all entries of an object in words. Combines consecutive entries that have the same data.
std::string object_words(const Object& object);
std::string constant_words(const Constant& constant);
std::string enumeration_words(const Enumeration& enumeration);
std::string table_words(const Table& table);
/// Returns names, direction, type, unit, range and the value at power-on.
std::string signal_words(const Signal& signal);

/// Returns the description of the device's item with this id. Returns an empty text for requirements and decisions,
/// because their own text is complete.
std::string item_words(const Part& part, const std::string& id);

/// Returns one cell of a table in words: `any`, `1 … 5`, `2 or 4`, `8110h`.
std::string cell_words(const Cell& cell);

}  // namespace canproof::host
