// SPDX-License-Identifier: Apache-2.0
// The fuzz targets of a build with their seeds, dictionaries and options.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct FuzzTarget {
    std::string name;                  ///< `sdo_server`
    std::filesystem::path program;     ///< libFuzzer program
    std::filesystem::path seeds;       ///< committed corpus; may be absent
    std::filesystem::path dictionary;  ///< empty: none
    std::vector<std::string> options;  ///< `-max_len=4096`
};

/// Returns all targets of `build` in alphabetical order, or those of `names`. The configure step lists them in
/// fuzz_targets.txt. A line has three fields separated by tabs: the name, the folder of NAME.dict and NAME.options, and
/// the folder of the seeds. NAME.options has the form of OSS-Fuzz: `[libfuzzer]`, `max_len = 4096`. Throws InputError
/// when there is no list, a name is unknown, a program is not built, or the list or an options file cannot be read.
std::vector<FuzzTarget> find_fuzz_targets(const std::filesystem::path& build, const std::vector<std::string>& names);

}  // namespace canproof::host
