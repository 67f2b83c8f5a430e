#include "host/assess/fuzz/fuzz_target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <regex>

#include "host/base/input_error.hpp"
#include "host/base/reading.hpp"

namespace canproof::host {

namespace {

const std::string suffix = "_fuzz";

std::vector<std::string> read_options(const std::filesystem::path& file) {
    std::vector<std::string> options{"-max_len=512"};
    std::ifstream in{file};
    static const std::regex setting{R"(\s*(\w+)\s*=\s*(\S+)\s*)"};
    static const std::regex other{R"(\s*(\[libfuzzer\]|#.*)?\s*)"};
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        std::smatch found;
        if (std::regex_match(line, found, setting)) {
            options.push_back(fmt::format("-{}={}", found[1].str(), found[2].str()));
        } else if (!std::regex_match(line, other)) {
            throw InputError{fmt::format("{}:{}: write `option = value` below [libfuzzer]", file.string(), number)};
        }
    }
    check_read(in, file.string());
    return options;
}

std::vector<std::string> names_in(const std::filesystem::path& build) {
    std::vector<std::string> names;
    if (std::filesystem::is_directory(build)) {
        for (const auto& file : std::filesystem::directory_iterator{build}) {
            const std::string name = file.path().filename().string();
            const bool fits = name.size() > suffix.size() && name.substr(name.size() - suffix.size()) == suffix;
            if (fits && file.is_regular_file() && file.path().extension().empty()) {
                names.push_back(name.substr(0, name.size() - suffix.size()));
            }
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

std::vector<FuzzTarget> find_fuzz_targets(const std::filesystem::path& build, const std::filesystem::path& fuzz,
                                          const std::vector<std::string>& names) {
    const std::vector<std::string> built = names_in(build);
    if (built.empty()) {
        throw InputError{
            fmt::format("{} has no fuzz targets; build them with `cmake --preset fuzz && cmake --build --preset fuzz "
                        "--target fuzz_targets`, or name their folder with --build",
                        build.string())};
    }
    for (const auto& name : names) {
        if (std::find(built.begin(), built.end(), name) == built.end()) {
            throw InputError{
                fmt::format("{} has no target `{}`; there are {}", build.string(), name, fmt::join(built, ", "))};
        }
    }
    std::vector<FuzzTarget> targets;
    for (const auto& name : names.empty() ? built : names) {
        const auto dictionary = fuzz / (name + ".dict");
        targets.push_back({name, std::filesystem::absolute(build / (name + suffix)), fuzz / "corpus" / name,
                           std::filesystem::exists(dictionary) ? dictionary : std::filesystem::path{},
                           read_options(fuzz / (name + ".options"))});
    }
    return targets;
}

}  // namespace canproof::host
