// Fixes in a data sheet what can be fixed without a change of meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

struct EdsFixed {
    std::string text;
    std::vector<EdsFinding> done;  ///< what was fixed; lines are those of the moment
};

/// Applies the edits of all findings that have some, and checks again until none is left. A sheet that is read as a
/// device gives the same device before and after. Throws InputError as check_eds() does.
EdsFixed fix_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
