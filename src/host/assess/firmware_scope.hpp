// Which files are firmware: src/firmware/**, src/devices/NAME/firmware/** and the drivers in src/target/stm32f405. What
// judges it asks here. The host's
// buses and replay are judged beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The path of a firmware file from the project's folder, as in `src/firmware/base/crc16.hpp` or
/// `src/devices/ax130751/firmware/ramp.cpp`. `file` is that path or ends with it behind a `/`, as compilers write it.
/// Empty for every other file.
std::string firmware_path(const std::string& file);

/// The same for a file of src/host/sim/bus or src/host/sim/replay, without the system calls of SocketCAN
/// (linux_can_system): only a kernel answers those.
std::string judged_host_path(const std::string& file);

/// The folders of the firmware that exist in the project: `src/firmware`, each `src/devices/NAME/firmware` in
/// alphabetical order of the devices, and `src/target/stm32f405`.
std::vector<std::string> firmware_folders(const std::filesystem::path& root);

/// Whether a test, a property or a fuzz target is one of the firmware, and so has to claim what it shows. `file` is
/// named from the project's folder. Those of the host are not, nor those of a device's simulation.
bool tests_the_firmware(const std::string& file);

}  // namespace canproof::host
