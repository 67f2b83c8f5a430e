// SPDX-License-Identifier: Apache-2.0
// Handles COB-IDs that a data sheet leaves at 0, which is the identifier of NMT commands.
#pragma once

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Replaces each COB-ID whose identifier is 0 with the COB-ID of the pre-defined connection set (CiA 301), and adds a
/// note. Switches off a PDO that is not in the set.
void mend_cob_ids(Part& part, const EdsTelling& tell);

}  // namespace canproof::host
