// Which files are firmware: src/firmware/** and src/devices/NAME/firmware/**. Whatever judges the firmware asks here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The path of a firmware file from the project's folder, as in `src/firmware/base/crc.cpp` or
/// `src/devices/NAME/firmware/ramp.cpp`. `file` is that path or ends with it behind a `/`, as compilers write it.
/// Empty for every other file.
std::string firmware_path(const std::string& file);

/// The folders of the firmware that exist in the project: `src/firmware` and each `src/devices/NAME/firmware`, in
/// alphabetical order of the devices.
std::vector<std::string> firmware_folders(const std::filesystem::path& root);

}  // namespace canproof::host
