// SPDX-License-Identifier: Apache-2.0
// The fuzz targets of a build with their seeds, dictionaries and options.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct FuzzTarget {
    std::string name;                  ///< `sdo_server`
    std::filesystem::path program;     ///< path of the target's program, which is built with libFuzzer
    std::filesystem::path seeds;       ///< folder of the committed corpus; it may be absent
    std::filesystem::path dictionary;  ///< path; empty: the target has no dictionary
    std::vector<std::string> options;  ///< arguments such as `-max_len=4096`
};

/// Returns the targets in the order of `names`; if `names` is empty, all targets of `build` in alphabetical order. The
/// configure step lists the targets in fuzz_targets.txt. Each line has three fields separated by tabs: the name, the
/// folder of NAME.dict and NAME.options, and the folder of the seeds. NAME.options has the form of OSS-Fuzz:
/// `[libfuzzer]`, `max_len = 4096`. Throws InputError when there is no list, a name is unknown, a program is not built,
/// or the list or an options file cannot be read.
std::vector<FuzzTarget> find_fuzz_targets(const std::filesystem::path& build, const std::vector<std::string>& names);

}  // namespace canproof::host
