// The register of a project's folder, for commands that need it whole.
#pragma once

#include <filesystem>

#include "host/register/register.hpp"

namespace canproof::host {

/// Throws InputError when the folder is not there or the register has faults.
Register sound_register(const std::filesystem::path& spec);

}  // namespace canproof::host
