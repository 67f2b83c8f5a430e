// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/implementing_mutants.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "host/assess/source/cpp_text.hpp"
#include "host/assess/source/linked_function.hpp"
#include "host/base/lines.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

/// The place of a mutant in a source, and the name (without a class) of the function that contains it.
struct FunctionPlace {
    std::size_t line{0};
    std::size_t number{0};
    std::string function;
};

using Words = std::set<std::string>;

FunctionPlace place_of(const AlteredCell& mutant) {
    const auto comma = mutant.cell.rfind(", line ");
    const std::string function = mutant.cell.substr(0, comma);
    const auto colons = function.rfind("::");
    return {std::stoul(mutant.cell.substr(comma + 7)), mutant.number,
            colons == std::string::npos ? function : function.substr(colons + 2)};
}

/// Adds to `words` each name that is directly before an opening parenthesis: the functions that the code calls.
void add_calls(const std::string& code, Words& words) {
    for (auto at = code.find('('); at != std::string::npos; at = code.find('(', at + 1)) {
        std::size_t first = at;
        while (first > 0 && is_word(code[first - 1])) {
            --first;
        }
        if (first < at) {
            words.insert(code.substr(first, at - first));
        }
    }
}

class Sources {
  public:
    Sources(std::filesystem::path root, const std::vector<AlteredCell>& mutants) : root_{std::move(root)} {
        for (const AlteredCell& mutant : mutants) {
            places_[mutant.item].push_back(place_of(mutant));
        }
    }

    /// Adds the mutants of the code below a link (implements<> assertion) and of the condition on which this code runs.
    /// Also adds the mutants of each function that this code or this condition calls, and of the functions that such a
    /// function calls in its own file.
    void add_function(const std::string& file, std::size_t link, std::set<std::size_t>& numbers) {
        Words called;
        for (const auto& [first, last] : {function_below(lines(file), link), condition_around(lines(file), link)}) {
            for (std::size_t at = first; at != 0 && at <= last; ++at) {
                add_calls(lines(file)[at - 1], called);
            }
            for (const FunctionPlace& place : places_[file]) {
                if (place.line >= first && place.line <= last) {
                    numbers.insert(place.number);
                }
            }
        }
        for (const auto& other : units_of(file)) {
            add_named(other, add_named(other, called, numbers), numbers);
        }
    }

  private:
    /// Returns the lines of a file without comments and literals. Returns no lines when the file does not exist.
    const std::vector<std::string>& lines(const std::string& file) {
        auto& all = lines_[file];
        if (all.empty() && std::filesystem::is_regular_file(root_ / file)) {
            all = split_lines(code_only(read_file(root_ / file)));
        }
        return all;
    }

    /// Adds to `numbers` the mutants in the functions of a file that have these names. Returns the names of the
    /// functions that the lines with these mutants call.
    Words add_named(const std::string& file, const Words& names, std::set<std::size_t>& numbers) {
        Words called;
        const auto found = places_.find(file);
        if (found == places_.end()) {
            return called;
        }
        for (const FunctionPlace& place : found->second) {
            if (names.count(place.function) != 0) {
                numbers.insert(place.number);
                add_calls(lines(file)[place.line - 1], called);
            }
        }
        return called;
    }

    /// Returns the file itself, the headers that it includes, and the source files of these headers.
    std::set<std::string> units_of(const std::string& file) {
        static const std::string include = "#include \"";
        std::set<std::string> files{file};
        const bool is_there = std::filesystem::is_regular_file(root_ / file);
        for (const auto& line : is_there ? read_lines(root_ / file) : std::vector<std::string>{}) {
            if (line.rfind(include, 0) == 0) {
                const std::string header = "src/" + line.substr(include.size(), line.rfind('"') - include.size());
                files.insert(header);
                files.insert(header.substr(0, header.rfind('.')) + ".cpp");
            }
        }
        return files;
    }

    std::filesystem::path root_;
    std::map<std::string, std::vector<FunctionPlace>> places_;
    std::map<std::string, std::vector<std::string>> lines_;
};

}  // namespace

std::map<std::string, std::vector<std::size_t>> implementing_mutants(const std::filesystem::path& root,
                                                                     const Evidence& evidence,
                                                                     const std::vector<AlteredCell>& mutants) {
    Sources sources{root, mutants};
    std::map<std::string, std::vector<std::size_t>> code;
    for (const auto& [id, places] : evidence.implemented) {
        std::set<std::size_t> numbers;
        for (const auto& place : places) {
            const auto colon = place.rfind(':');
            sources.add_function(place.substr(0, colon), std::stoul(place.substr(colon + 1)), numbers);
        }
        code[id].assign(numbers.begin(), numbers.end());
    }
    for (const auto& [id, shared] : evidence.implemented_by) {
        if (code[id].empty()) {
            code[id] = code[shared];
        }
    }
    return code;
}

}  // namespace canproof::host
