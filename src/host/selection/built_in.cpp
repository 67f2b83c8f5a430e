// SPDX-License-Identifier: Apache-2.0
#include "host/selection/built_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>

#include "host/base/input_error.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

/// Compares without regard to case: part numbers are printed in capitals, names of devices are not.
bool same(const std::string& number, const std::string& name) {
    const auto lower = [](unsigned char c) { return std::tolower(c); };
    return std::equal(number.begin(), number.end(), name.begin(), name.end(), [&](char a, char b) {
        return lower(static_cast<unsigned char>(a)) == lower(static_cast<unsigned char>(b));
    });
}

/// Returns the requirements register of the embedded files whose path `is_wanted` accepts. Returns nothing when the
/// register of these files alone has faults.
template <typename Wanted>
std::optional<Register> register_of(const Wanted& is_wanted) {
    SpecFiles files;
    for (const auto& [path, text] : embedded_spec()) {
        if (is_wanted(path)) {
            files.emplace(path, text);
        }
    }
    return read_sound_register(files);
}

/// Returns a requirements register with the names and part numbers of all devices, read from their device.toml alone.
const Register& device_files() {
    static const Register content =
        register_of([](const std::filesystem::path& path) { return path.filename() == "device.toml"; }).value();
    return content;
}

/// Returns the requirements register's description of one device. Reads the files of this device alone, because most
/// runs use one device of the four.
const Part& device_part(const std::string& name) {
    static std::map<std::string, std::optional<Register>> read;
    const auto [known, unread] = read.try_emplace(name);
    if (unread) {
        const std::string folder = "spec/devices/" + name + "/";
        known->second = register_of([&folder](const std::string& path) { return path.rfind(folder, 0) == 0; });
    }
    return *(known->second ? *known->second : built_in_register()).part(name);
}

/// Returns whether this is a device (not the shared rules) with this name or part number.
bool is_called(const Part& part, const std::string& name) {
    const auto& numbers = part.info.part_numbers;
    return part.is_device() && (part.name == name || std::any_of(numbers.begin(), numbers.end(),
                                                                 [&](const auto& n) { return same(n, name); }));
}

}  // namespace

const Register& built_in_register() {
    // The build has checked that the requirements register has no faults.
    static const Register content = read_sound_register(embedded_spec()).value();
    return content;
}

std::vector<std::string> device_names() {
    std::vector<std::string> names;
    for (const Part& one : device_files().parts) {
        if (one.is_device()) {
            names.push_back(one.name);
            const auto& numbers = one.info.part_numbers;
            std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(names),
                         [&one](const std::string& number) { return !same(number, one.name); });
        }
    }
    return names;
}

bool is_device_name(const std::string& name) {
    const auto& parts = device_files().parts;
    return std::any_of(parts.begin(), parts.end(), [&](const Part& one) { return is_called(one, name); });
}

const Part& device_named(const std::string& name) {
    for (const Part& one : device_files().parts) {
        if (is_called(one, name)) {
            return device_part(one.name);
        }
    }
    throw InputError{
        fmt::format("there is no device `{}` in this program; `canproof devices` lists its devices", name)};
}

}  // namespace canproof::host
