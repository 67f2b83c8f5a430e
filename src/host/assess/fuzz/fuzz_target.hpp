// The fuzz targets of a build, each with what fuzzing it needs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct FuzzTarget {
    std::string name;                  ///< `sdo_server`
    std::filesystem::path program;     ///< libFuzzer
    std::filesystem::path seeds;       ///< committed corpus; need not exist
    std::filesystem::path dictionary;  ///< empty: none
    std::vector<std::string> options;  ///< `-max_len=4096`
};

/// All NAME_fuzz of `build`, or those of `names`, in alphabetical order; seeds, dictionaries and NAME.options
/// (OSS-Fuzz's form: `[libfuzzer]`, `max_len = 4096`) from `fuzz`. Throws InputError when there are none, a name is
/// unknown, or an options file cannot be read.
std::vector<FuzzTarget> find_fuzz_targets(const std::filesystem::path& build, const std::filesystem::path& fuzz,
                                          const std::vector<std::string>& names);

}  // namespace canproof::host
