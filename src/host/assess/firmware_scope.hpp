// SPDX-License-Identifier: Apache-2.0
// Defines which files are firmware: src/firmware/**, src/devices/NAME/firmware/** and the drivers in
// src/target/stm32f405 and src/target/zynqmp. All assessments use this definition. Coverage and mutation also assess
// the host's buses and replay.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// Returns the path of a firmware file relative to the project's folder, such as `src/firmware/base/crc16.hpp` or
/// `src/devices/ax130751/firmware/ramp.cpp`. `file` is this path, or an absolute path that ends with it, as compilers
/// write it. Returns an empty text for every other file.
std::string firmware_path(const std::string& file);

/// Returns the path relative to the project's folder for a file of src/host/sim/bus or src/host/sim/replay. Returns an
/// empty text for every other file and for the system calls of SocketCAN (linux_can_system), because only a kernel
/// answers them.
std::string judged_host_path(const std::string& file);

/// Returns the existing folders of the firmware: `src/firmware`, each `src/devices/NAME/firmware` in alphabetical order
/// of the devices, `src/target/stm32f405` and `src/target/zynqmp`.
std::vector<std::string> firmware_folders(const std::filesystem::path& root);

/// Returns whether this file contains a test, property or fuzz target of the firmware. Such a test must name the items
/// that it verifies. `file` is relative to the project's folder. Tests of the host or of a device's simulation do not
/// test the firmware.
bool tests_the_firmware(const std::string& file);

}  // namespace canproof::host
