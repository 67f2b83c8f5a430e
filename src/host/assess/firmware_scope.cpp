// SPDX-License-Identifier: Apache-2.0
#include "host/assess/firmware_scope.hpp"

#include <algorithm>

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

const std::string shared = "src/firmware/";
const std::string devices = "src/devices/";
const std::string part = "/firmware/";
const std::string drivers = "src/target/stm32f405/";
const std::string second_drivers = "src/target/zynqmp/";
const std::string host_bus = "src/host/sim/bus/";
const std::string host_replay = "src/host/sim/replay/";
const std::string device_tests = "tests/devices/";
const std::string simulation = "/simulation/";

/// Returns whether a path relative to the project's folder names a file of the firmware.
bool is_firmware(const std::string& path) {
    for (const std::string& folder : {shared, drivers, second_drivers}) {
        if (path.rfind(folder, 0) == 0) {
            return path.size() > folder.size();
        }
    }
    const auto name_end = path.rfind(devices, 0) == 0 ? path.find('/', devices.size()) : std::string::npos;
    return name_end != std::string::npos && name_end > devices.size() &&
           path.compare(name_end, part.size(), part) == 0 && path.size() > name_end + part.size();
}

/// Returns whether a path relative to the project's folder names a file of the host program whose coverage and mutation
/// are assessed, as for the firmware.
bool is_judged_host(const std::string& path) {
    const auto below = [&path](const std::string& folder) {
        return path.rfind(folder, 0) == 0 && path.size() > folder.size();
    };
    return below(host_replay) || (below(host_bus) && path.rfind(host_bus + "linux_can_system.", 0) != 0);
}

/// Returns the shortest end of the path `file` that starts with the folder `src/` and that `fits` accepts; an empty
/// text when there is none. The shortest end is relative to the project, even if the project is below a folder `src/`.
std::string path_that(bool (*fits)(const std::string&), const std::string& file) {
    for (auto at = file.rfind("src/"); at != std::string::npos;
         at = at == 0 ? std::string::npos : file.rfind("src/", at - 1)) {
        if ((at == 0 || file[at - 1] == '/') && fits(file.substr(at))) {
            return file.substr(at);
        }
    }
    return "";
}

}  // namespace

std::string firmware_path(const std::string& file) {
    return path_that(is_firmware, file);
}

std::string judged_host_path(const std::string& file) {
    return path_that(is_judged_host, file);
}

std::vector<std::string> firmware_folders(const fs::path& root) {
    std::vector<std::string> folders;
    if (fs::is_directory(root / "src" / "devices")) {
        for (const auto& device : fs::directory_iterator{root / "src" / "devices"}) {
            if (fs::is_directory(device.path() / "firmware")) {
                folders.push_back((device.path() / "firmware").lexically_relative(root).generic_string());
            }
        }
    }
    std::sort(folders.begin(), folders.end());
    if (fs::is_directory(root / "src" / "firmware")) {
        folders.insert(folders.begin(), "src/firmware");
    }
    for (const std::string& folder : {drivers, second_drivers}) {
        if (fs::is_directory(root / folder)) {
            folders.push_back(folder.substr(0, folder.size() - 1));
        }
    }
    return folders;
}

bool tests_the_firmware(const std::string& file) {
    const auto below = [&file](const std::string& folder) { return file.rfind(folder, 0) == 0; };
    if (below(device_tests)) {
        const auto name_end = file.find('/', device_tests.size());
        return name_end == std::string::npos || file.compare(name_end, simulation.size(), simulation) != 0;
    }
    return below("tests/conformance/") || below("tests/firmware/") || below("tests/target/") || below("fuzz/") ||
           (below("properties/") && !below("properties/host/"));
}

}  // namespace canproof::host
