// SPDX-License-Identifier: Apache-2.0
// The requirements register of a project's folder, for commands that need it without faults.
#pragma once

#include <filesystem>

#include "host/register/register.hpp"

namespace canproof::host {

/// Reads the register. Throws InputError when the folder does not exist or the register has faults.
Register sound_register(const std::filesystem::path& spec);

}  // namespace canproof::host
