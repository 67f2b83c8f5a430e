// SPDX-License-Identifier: Apache-2.0
// A data sheet without findings, and changes of it in a short notation.
#pragma once

#include <string>
#include <vector>

namespace canproof::host::test {

/// A device with two receive PDOs, one transmit PDO, and an entry of each kind of type.
const std::string& good_sheet();

struct PatchedSheet {
    std::string text;
    std::vector<unsigned> lines;  ///< lines touched by the patches; only those marked with @ if there are any
};

/// Returns good_sheet() with patches, separated by ` | `:
///   [1017] DefaultValue=5     sets a key; adds it or its section when missing
///   [1017] +DefaultValue=5    adds a line even when the key exists
///   [1017] -DefaultValue      removes a line
///   [1017] DataType~TEXT      replaces a line by TEXT
///   [1017] ~TEXT              replaces the line of the section by TEXT
///   -[1017]                   removes a section
///   top TEXT, end TEXT        adds a line at the beginning or the end
///   @[1017] @[1017] Key @1    touches the line of a section, of a key, or a line
PatchedSheet patched_sheet(const std::string& patches);

}  // namespace canproof::host::test
