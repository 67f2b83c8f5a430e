// SPDX-License-Identifier: Apache-2.0
// Reads the requirements register of a project, for commands that need a register without faults.
#pragma once

#include <filesystem>

#include "host/register/register.hpp"

namespace canproof::host {

/// Reads the requirements register. Throws InputError when the folder does not exist or the register has faults.
Register sound_register(const std::filesystem::path& spec);

}  // namespace canproof::host
