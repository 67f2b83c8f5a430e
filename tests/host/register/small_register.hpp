// SPDX-License-Identifier: Apache-2.0
// A valid register of a few lines; each test breaks one thing in it.
#pragma once

#include <string>

#include "host/register/load.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host::test {

inline const std::string manual_file = "spec/manuals/m.toml";
inline const std::string device_file = "spec/devices/box/device.toml";
inline const std::string items_file = "spec/devices/box/items.toml";
inline const std::string shared_file = "spec/canopen/shared.toml";

/// Returns the files of small/spec, which are compiled in: manual M1 with section 1 (which describes 2000h),
/// section 2.1 and Table 3; device `box`, prefix AO4.
const SpecFiles& small_register();

/// Returns the small register with one file added or replaced.
inline SpecFiles with(const std::string& path, const std::string& text) {
    SpecFiles files = small_register();
    files[path] = text;
    return files;
}

inline std::string all_faults(const LoadResult& loaded) {
    std::string text;
    for (const Fault& fault : loaded.faults) {
        text += fault.text() + "\n";
    }
    return text;
}

/// Returns the text with CRLF line ends, as in an EDS.
inline std::string crlf(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '\n' ? std::string{"\r\n"} : std::string{c};
    }
    return out;
}

}  // namespace canproof::host::test
