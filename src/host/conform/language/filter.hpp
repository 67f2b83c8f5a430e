// SPDX-License-Identifier: Apache-2.0
// A filter that selects entries of the data sheet, for a step of a conformance case or for a condition under which the
// case applies: `writable, u16, upper limit`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/conform/language/scanner.hpp"
#include "host/conform/language/value.hpp"
#include "host/conform/sheet/conform_sheet.hpp"

namespace canproof::host::conform {

struct Filter {
    std::string words;  ///< text of the filter as written in the case
    std::vector<std::function<bool(const SheetEntry&)>> tests;

    bool passes(const SheetEntry& one) const;
    /// Returns all entries that pass the filter, in ascending order.
    std::vector<SheetEntry> select(const ConformSheet& sheet) const;
};

/// Parses a filter up to the text `end`, or up to the end of the line if `end` is empty. Throws LanguageError.
Filter parse_filter(Scanner& line, const std::string& end);

/// Returns an entry as a variable with the fields index, sub, size, bits, type, code, high, low, default, readable,
/// writable.
Value entry_value(const ConformSheet& sheet, const SheetEntry& one);

}  // namespace canproof::host::conform
