// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/fuzz_target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <map>
#include <regex>

#include "host/base/input_error.hpp"
#include "host/base/reading.hpp"

namespace canproof::host {

namespace {

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
            throw InputError{fmt::format("{}:{}: the line is no option; write `option = value` below [libfuzzer]",
                                         file.string(), number)};
        }
    }
    check_read(in, file.string());
    return options;
}

const char* const how_to_build = "`cmake --preset fuzz && cmake --build --preset fuzz --target fuzz_targets`";

/// The three fields of a line in fuzz_targets.txt, the build's list of fuzz targets.
struct Line {
    std::string name;
    std::filesystem::path folder;
    std::filesystem::path seeds;
};

Line read_line(const std::string& text, const std::string& place) {
    static const std::regex three_words{"([^\t]+)\t([^\t]+)\t([^\t]+)"};
    std::smatch found;
    if (!std::regex_match(text, found, three_words)) {
        throw InputError{fmt::format(
            "{}: the line does not have three fields; write a target's name, folder and corpus with tabs between them",
            place)};
    }
    return {found[1].str(), found[2].str(), found[3].str()};
}

/// Returns the lines of the build's list of targets, by target name. Throws InputError for a line without three fields,
/// and for an empty list.
std::map<std::string, Line> lines_of(const std::filesystem::path& build) {
    const auto list = build / "fuzz_targets.txt";
    std::ifstream in{list};
    std::map<std::string, Line> lines;
    int number = 0;
    for (std::string text; std::getline(in, text);) {
        const Line line = read_line(text, fmt::format("{}:{}", list.string(), ++number));
        lines.emplace(line.name, line);
    }
    if (lines.empty()) {
        throw InputError{fmt::format("{} has no fuzz targets; build them with {}, or name their folder with --build",
                                     build.string(), how_to_build)};
    }
    check_read(in, list.string());
    return lines;
}

FuzzTarget target_of(const std::filesystem::path& build, const Line& line) {
    const auto program = build / (line.name + "_fuzz");
    if (!std::filesystem::exists(program)) {
        throw InputError{fmt::format("{} is not built; build it with {}, or name other targets with --targets",
                                     program.string(), how_to_build)};
    }
    const auto dictionary = line.folder / (line.name + ".dict");
    return {line.name, std::filesystem::absolute(program), line.seeds,
            std::filesystem::exists(dictionary) ? dictionary : std::filesystem::path{},
            read_options(line.folder / (line.name + ".options"))};
}

}  // namespace

std::vector<FuzzTarget> find_fuzz_targets(const std::filesystem::path& build, const std::vector<std::string>& names) {
    const auto listed = lines_of(build);
    std::vector<std::string> known;
    for (const auto& [name, line] : listed) {
        known.push_back(name);
    }
    std::vector<FuzzTarget> targets;
    for (const auto& name : names.empty() ? known : names) {
        const auto line = listed.find(name);
        if (line == listed.end()) {
            throw InputError{
                fmt::format("{} has no target `{}`; its targets are {}", build.string(), name, fmt::join(known, ", "))};
        }
        targets.push_back(target_of(build, line->second));
    }
    return targets;
}

}  // namespace canproof::host
