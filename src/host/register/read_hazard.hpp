// SPDX-License-Identifier: Apache-2.0
// Reads the hazards of the register.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

Hazard read_hazard(TomlItem& item);

}  // namespace canproof::host
