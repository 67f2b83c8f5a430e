// SPDX-License-Identifier: Apache-2.0
// Fixes the faults of a data sheet whose fix keeps its meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

struct EdsFixed {
    std::string text;
    std::vector<EdsFinding> done;  ///< the fixed findings; their lines refer to the text at that moment
};

/// Applies the edits of all findings that have some, and checks again until none is left. If the sheet can be read as a
/// device, the fixed sheet gives the same device. Throws InputError as check_eds() does.
EdsFixed fix_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
