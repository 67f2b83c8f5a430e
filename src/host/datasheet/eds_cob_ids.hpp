// SPDX-License-Identifier: Apache-2.0
// Handles COB-IDs that a data sheet leaves at 0, which is the identifier of NMT commands.
#pragma once

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Replaces each COB-ID that is not switched off and has the identifier 0: it gets the COB-ID of the pre-defined
/// connection set (CiA 301). Switches off such a PDO if it is not in the set. Adds a note for each change.
void mend_cob_ids(Part& part, const EdsTelling& tell);

}  // namespace canproof::host
