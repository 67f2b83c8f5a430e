// A data sheet without any finding, and changes of it in a short form.
#pragma once

#include <string>
#include <vector>

namespace canproof::host::test {

/// A device with two receive PDOs, one transmit PDO, and an entry of each kind of type.
const std::string& good_sheet();

struct PatchedSheet {
    std::string text;
    std::vector<unsigned> lines;  ///< that the patches touched; those marked with @ alone where there are any
};

/// good_sheet() with patches, which ` | ` separates:
///   [1017] DefaultValue=5     sets a key, adding it or its section where it is missing
///   [1017] +DefaultValue=5    adds a line even where the key stands
///   [1017] -DefaultValue      removes a line
///   [1017] DataType~TEXT      puts TEXT in place of a line
///   [1017] ~TEXT              puts TEXT in place of the section's line
///   -[1017]                   removes a section
///   top TEXT, end TEXT        adds a line at the beginning or the end
///   @[1017] @[1017] Key @1    touches a section's line, a key's line, or a line
PatchedSheet patched_sheet(const std::string& patches);

}  // namespace canproof::host::test
