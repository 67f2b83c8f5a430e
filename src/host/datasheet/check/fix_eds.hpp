// SPDX-License-Identifier: Apache-2.0
// Fixes those faults of a data sheet that can be fixed without a change of the sheet's meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

struct EdsFixed {
    std::string text;
    /// fixed findings; line numbers refer to the text at the start of the round that fixed the finding
    std::vector<EdsFinding> done;
};

/// Applies the edits of all findings that have edits, and checks again until no such finding is left (at most 20
/// times). If a device can be read from the sheet, the fixed sheet gives the same device. Throws InputError as
/// check_eds() does.
EdsFixed fix_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
