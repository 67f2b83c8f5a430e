// Which entries of the data sheet a step or a need means: `writable, u16, upper limit`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/conform/language/scanner.hpp"
#include "host/conform/language/value.hpp"
#include "host/conform/sheet/conform_sheet.hpp"

namespace canproof::host::conform {

struct Filter {
    std::string words;  ///< as written
    std::vector<std::function<bool(const SheetEntry&)>> tests;

    bool passes(const SheetEntry& one) const;
    /// All entries that pass, ascending.
    std::vector<SheetEntry> select(const ConformSheet& sheet) const;
};

/// Up to `end`, or to the end of the line for an empty one. Throws LanguageError.
Filter parse_filter(Scanner& line, const std::string& end);

/// An entry as a variable with the fields index, sub, size, bits, type, high, low, default, readable, writable.
Value entry_value(const ConformSheet& sheet, const SheetEntry& one);

}  // namespace canproof::host::conform
