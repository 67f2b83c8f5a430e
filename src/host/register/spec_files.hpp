// The files of a register, as texts.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// Files by path: "spec/devices/x/device.toml" → text.
using SpecFiles = std::map<std::string, std::string>;

/// The .toml files below a folder, as if it were named spec/. Throws InputError when there are none.
SpecFiles read_spec_files(const std::filesystem::path& spec);

}  // namespace canproof::host
