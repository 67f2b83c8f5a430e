// SPDX-License-Identifier: Apache-2.0
// Handles COB-IDs that a data sheet leaves at 0, which is the identifier of NMT commands.
#pragma once

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Replaces them by the COB-IDs of CiA 301's pre-defined connection set, each with a note. PDOs beyond this set get
/// switched off.
void mend_cob_ids(Part& part, const EdsTelling& tell);

}  // namespace canproof::host
