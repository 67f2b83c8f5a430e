// SPDX-License-Identifier: Apache-2.0
// Replaces COB-IDs that a data sheet leaves at 0, because 0 is the identifier of NMT commands.
#pragma once

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Replaces each COB-ID that is not switched off and has the identifier 0 by the COB-ID of the pre-defined connection
/// set (CiA 301). Switches off a PDO with such a COB-ID if the set does not contain the PDO. Adds a note for each
/// change.
void mend_cob_ids(Part& part, const EdsTelling& tell);

}  // namespace canproof::host
