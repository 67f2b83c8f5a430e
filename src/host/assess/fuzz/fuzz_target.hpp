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

/// All targets of `build`, in alphabetical order, or those of `names`. Its configure step lists them in
/// fuzz_targets.txt, a line each, with tabs: the name, the folder of NAME.dict and NAME.options (OSS-Fuzz's form:
/// `[libfuzzer]`, `max_len = 4096`), the folder of the seeds. Throws InputError when there is no list, a name is
/// unknown, a program is not built, or the list or an options file cannot be read.
std::vector<FuzzTarget> find_fuzz_targets(const std::filesystem::path& build, const std::vector<std::string>& names);

}  // namespace canproof::host
