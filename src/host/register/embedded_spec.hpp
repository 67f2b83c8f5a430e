// SPDX-License-Identifier: Apache-2.0
// The files of the requirements register at build time, embedded in the program canproof. Files that contain only
// statements, decisions, hazards or reviews are left out.
#pragma once

#include "host/register/spec_files.hpp"

namespace canproof::host {

const SpecFiles& embedded_spec();

}  // namespace canproof::host
