// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/code_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <set>

#include "host/assess/firmware_scope.hpp"
#include "host/assess/source/cpp_text.hpp"
#include "host/base/lines.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sources_below(const fs::path& folder) {
    std::vector<fs::path> all;
    if (fs::is_directory(folder)) {
        for (const auto& file : fs::recursive_directory_iterator(folder)) {
            const auto ending = file.path().extension();
            if (file.is_regular_file() && (ending == ".hpp" || ending == ".cpp")) {
                all.push_back(file.path());
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Returns the unit of a file, which is its path without extension: `devices/ax130751/firmware/ramp` for
/// src/devices/ax130751/firmware/ramp.hpp and ramp.cpp.
std::string unit_of(std::string file) {
    return file.substr(0, file.rfind('.'));
}

std::vector<std::string> includes_of(const fs::path& file) {
    static const std::string word = "#include \"";
    static const std::string written =
        "#include \\\"";  // an include line in a string literal of src/host/codegen, which writes generated code
    std::vector<std::string> all;
    for (const auto& line : read_lines(file)) {
        if (line.rfind(word, 0) == 0) {
            all.push_back(line.substr(word.size(), line.rfind('"') - word.size()));
        }
        for (auto at = line.find(written); at != std::string::npos; at = line.find(written, at)) {
            at += written.size();
            all.push_back(line.substr(at, line.find('\\', at) - at));
        }
    }
    return all;
}

/// The ids of items by the C++ names that are generated from these items.
using Names = std::map<std::string, std::vector<std::string>>;

/// Adds the items that the firmware uses only under a common name: the tables of errors and their enumerations as
/// `error_table`, and the table of bit rates as `profile`.
void add_names_of_node(const Part& part, Names& names) {
    for (const auto& table : part.tables) {
        if (table.id == part.info.lss_bit_rates) {
            names["profile"].push_back(table.id);
        }
        if (table.errors.empty()) {
            continue;
        }
        names["error_table"].push_back(table.id);
        for (const auto& column : table.outputs) {
            if (!column.enumeration.empty()) {
                names["error_table"].push_back(column.enumeration);
            }
        }
    }
}

Names generated_names(const Part& part) {
    Names names;
    add_names_of_node(part, names);
    for (const auto& constant : part.constants) {
        names[constant.name].push_back(constant.id);
    }
    for (const auto& enumeration : part.enumerations) {
        names[enumeration.name].push_back(enumeration.id);
    }
    for (const auto& signal : part.signals) {
        std::string name = signal.name;
        if (const auto at = name.find("{n}"); at != std::string::npos) {
            name.erase(at, 3);
        }
        names[name].push_back(signal.id);
    }
    return names;
}

/// Calls visit(name) for each identifier of a line. Ignores a comment at the end of the line.
template <typename Visit>
void for_each_name(const std::string& line, const Visit& visit) {
    const std::size_t end = std::min(line.find("//"), line.size());
    for (std::size_t at = 0; at < end;) {
        if (!is_word(line[at])) {
            ++at;
            continue;
        }
        std::size_t last = at;
        while (last < end && is_word(line[last])) {
            ++last;
        }
        visit(line.substr(at, last - at));
        at = last;
    }
}

/// Returns the id of an object by its field in the dictionary: `o2340_…` belongs to 2340h. Returns nothing for any
/// other name.
std::vector<std::string> object_of(const std::string& name, const Part& part) {
    if (name.size() < 6 || name[0] != 'o' || name[5] != '_') {
        return {};
    }
    const std::string index = name.substr(1, 4);
    for (const auto& object : part.objects) {
        if (fmt::format("{:04x}", object.index) == index) {
            return {object.id};
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> untraced_files(const fs::path& source, const Evidence& evidence) {
    std::map<std::string, std::set<std::string>> included;  // units (paths without extension) that each unit includes
    std::set<std::string> firmware;
    for (const auto& file : sources_below(source)) {
        const std::string name = file.lexically_relative(source).generic_string();
        if (!firmware_path("src/" + name).empty()) {
            firmware.insert(name);
        }
        for (const auto& other : includes_of(file)) {
            included[unit_of(name)].insert(unit_of(other));
        }
    }
    std::set<std::string> traced;
    std::deque<std::string> open;
    for (const auto& [id, places] : evidence.implemented) {
        for (const auto& place : places) {
            // removes `src/` and the line number from the place
            open.push_back(unit_of(place.substr(4, place.rfind(':') - 4)));
        }
    }
    for (const auto& [unit, others] : included) {
        if (unit.rfind("host/codegen/write_", 0) == 0) {
            // these sources write generated code: also follows the units that this code includes
            open.insert(open.end(), others.begin(), others.end());
        }
    }
    while (!open.empty()) {
        const std::string unit = open.front();
        open.pop_front();
        if (traced.insert(unit).second) {
            open.insert(open.end(), included[unit].begin(), included[unit].end());
        }
    }
    std::vector<std::string> untraced;
    for (const auto& name : firmware) {
        if (traced.count(unit_of(name)) == 0) {
            untraced.push_back("src/" + name);
        }
    }
    return untraced;
}

std::map<std::string, std::vector<std::string>> generated_uses(const fs::path& root, const Register& content) {
    std::map<std::string, Names> names;
    for (const auto& part : content.parts) {
        names[part.cpp_name()] = generated_names(part);
    }
    std::map<std::string, std::vector<std::string>> uses;
    for (const auto& file : sources_below(root / "src")) {
        const std::string name = file.lexically_relative(root).generic_string();
        // the path src/devices/cbx-ao412/… names the device cbx_ao412, as code does with `generated::cbx_ao412`
        std::string path_word = name;
        std::replace(path_word.begin(), path_word.end(), '-', '_');
        const std::string all = read_file(file);
        const std::vector<std::string> lines = split_lines(all);
        for (const auto& part : content.parts) {
            // Only code that names a device (or `canopen`) can use the names that are generated for it.
            if (all.find("generated::" + part.cpp_name()) == std::string::npos &&
                all.find("generated/" + part.cpp_name()) == std::string::npos &&
                path_word.find(part.cpp_name()) == std::string::npos) {
                continue;
            }
            std::set<std::string> seen;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                for_each_name(lines[i], [&](const std::string& word) {
                    const auto found = names[part.cpp_name()].find(word);
                    const auto ids = found == names[part.cpp_name()].end() ? object_of(word, part) : found->second;
                    for (const std::string& id : ids) {
                        if (seen.insert(id).second) {
                            uses[id].push_back(fmt::format("{}:{}", name, i + 1));
                        }
                    }
                });
            }
        }
    }
    return uses;
}

}  // namespace canproof::host
