// SPDX-License-Identifier: Apache-2.0
// Reads the JSON export of llvm-cov (format version 2.0.1 of LLVM 19).
#include "host/assess/coverage/read_coverage.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/firmware_scope.hpp"
#include "host/base/input_error.hpp"
#include "host/base/lines.hpp"
#include "host/base/trimmed.hpp"

namespace canproof::host {

namespace {

/// Start and end of a region of a source. Lines and columns count from 1; the end is one column after the last
/// character.
struct Region {
    unsigned line{0};
    unsigned column{0};
    unsigned end_line{0};
    unsigned end_column{0};

    bool operator<(const Region& other) const {
        return std::tie(line, column, end_line, end_column) <
               std::tie(other.line, other.column, other.end_line, other.end_column);
    }
    bool holds(const Region& inner) const {
        return std::tie(line, column) <= std::tie(inner.line, inner.column) &&
               std::tie(inner.end_line, inner.end_column) <= std::tie(end_line, end_column);
    }
};

Region region_of(const nlohmann::json& values) {
    return {values.at(0), values.at(1), values.at(2), values.at(3)};
}

/// Returns the lines of a source. Throws InputError when the source is missing or, with SourceAge::by_time, is newer
/// than `measured`.
std::vector<std::string> lines_of(const std::filesystem::path& file, const std::filesystem::path& measured,
                                  const SourceAge age) {
    if (!std::filesystem::exists(file)) {
        throw InputError{fmt::format("{} was measured but does not exist any more; run tests/coverage to measure again",
                                     file.string())};
    }
    if (age == SourceAge::by_time &&
        std::filesystem::last_write_time(file) > std::filesystem::last_write_time(measured)) {
        throw InputError{
            fmt::format("{} has changed since it was measured; run tests/coverage to measure again", file.string())};
    }
    return read_lines(file);
}

/// Returns the text of a region on one line, with one space for each line break.
std::string text_of(const Region& region, const std::vector<std::string>& lines) {
    std::string text;
    for (unsigned line = region.line; line <= region.end_line && line <= lines.size(); ++line) {
        std::string part = lines[line - 1];
        if (line == region.end_line) {
            part = part.substr(0, region.end_column - 1);
        }
        if (line == region.line) {
            part = part.substr(std::min<std::size_t>(region.column - 1, part.size()));
        }
        text += (text.empty() ? "" : " ") + trimmed(part);
    }
    return text;
}

/// Numbers of executions of the two outcomes of a branch, summed over all instantiations of a template.
struct Ways {
    unsigned long long taken{0};
    unsigned long long passed{0};
};

class FileReader {
  public:
    FileReader(const nlohmann::json& source, std::string name, std::vector<std::string> lines)
        : source_{source}, lines_{std::move(lines)} {
        made_.file = std::move(name);
    }

    /// Returns the coverage of the file. `functions` gives the number of executions and the name of each function by
    /// the region of its body.
    FileCoverage read(const std::map<Region, std::pair<unsigned long long, std::string>>& functions) {
        for (const auto& [body, function] : functions) {
            made_.functions.add({function.first == 0 ? 0U : 1U, 1});
            if (function.first == 0) {
                add_gap("function", body.line, function.second, "never called");
                silent_.push_back(body);
            }
        }
        read_lines();
        read_branches_and_conditions();
        std::sort(made_.gaps.begin(), made_.gaps.end(), [](const CoverageGap& a, const CoverageGap& b) {
            return std::tie(a.line, a.kind, a.code) < std::tie(b.line, b.kind, b.code);
        });
        return std::move(made_);
    }

  private:
    void add_gap(const char* kind, const unsigned line, std::string code, std::string missing) {
        made_.gaps.push_back({kind, made_.file, line, std::move(code), std::move(missing)});
    }

    bool is_silent(const unsigned line) const {
        return std::any_of(silent_.begin(), silent_.end(),
                           [line](const Region& body) { return body.line <= line && line <= body.end_line; });
    }

    /// Sets the number of executions of each line. It is the greatest number of the regions that start on the line, or,
    /// if no region starts there, the number of the region that continues from the line before.
    void read_lines() {
        const nlohmann::json& segments = source_.at("segments");
        std::size_t at = 0;
        bool counts = false;
        unsigned long long wrapped = 0;
        for (unsigned line = 1; line <= lines_.size(); ++line) {
            bool begins = false;
            bool skipped = false;
            unsigned long long most = counts ? wrapped : 0;
            const bool reached = counts;
            for (bool first = true; at < segments.size() && segments[at].at(0).get<unsigned>() == line; ++at) {
                const nlohmann::json& segment = segments[at];
                const bool has_count = segment.at(3);
                const bool entry = segment.at(4);
                const bool gap = segment.size() > 5 && segment.at(5).get<bool>();
                skipped = skipped || (first && entry && !has_count);
                first = false;
                if (has_count && entry && !gap) {
                    most = std::max(begins ? most : 0ULL, segment.at(2).get<unsigned long long>());
                    begins = true;
                }
                counts = has_count;
                wrapped = segment.at(2);
            }
            if (!skipped && (reached || begins)) {
                made_.lines[line] = most;
            }
        }
        tell_silent_lines();
    }

    /// Adds one gap for each sequence of consecutive lines that never ran, with the text of the first line. An empty
    /// line or a line with only `}` ends a sequence. Omits the bodies of functions that were never called: each is
    /// already a gap.
    void tell_silent_lines() {
        unsigned last = 0;
        for (const auto& [line, count] : made_.lines) {
            const std::string text = trimmed(lines_[line - 1]);
            if (count != 0 || is_silent(line) || text.empty() || text == "}") {
                continue;
            }
            if (last == 0 || line != last + 1) {
                add_gap("line", line, text, "never run");
            }
            last = line;
        }
    }

    void read_branches_and_conditions() {
        std::map<Region, Ways> branches;
        for (const auto& branch : source_.at("branches")) {
            Ways& ways = branches[region_of(branch)];
            ways.taken += branch.at(4).get<unsigned long long>();
            ways.passed += branch.at(5).get<unsigned long long>();
        }
        const std::set<Region> reported = read_conditions(branches);
        for (const auto& [place, ways] : branches) {
            const CoverageCount count{static_cast<std::size_t>((ways.taken != 0) + (ways.passed != 0)), 2};
            made_.branches.add(count);
            made_.line_branches[place.line].add(count);
            if (count.covered < 2 && reported.count(place) == 0 && !is_silent(place.line)) {
                add_gap("branch", place.line, text_of(place, lines_), missing_of(ways));
            }
        }
    }

    static std::string missing_of(const Ways& ways) {
        if (ways.taken == 0 && ways.passed == 0) {
            return "never reached";
        }
        return ways.taken == 0 ? "never true" : "never false";
    }

    /// Reads the MC/DC conditions. llvm-cov lists the conditions of a decision in the order of the source. Returns the
    /// regions of the conditions that are gaps.
    std::set<Region> read_conditions(const std::map<Region, Ways>& branches) {
        std::map<Region, std::vector<bool>> decisions;
        for (const auto& record : source_.at("mcdc_records")) {
            const auto shown = record.back().get<std::vector<bool>>();
            auto& all = decisions[region_of(record)];
            all.resize(std::max(all.size(), shown.size()));
            for (std::size_t i = 0; i < shown.size(); ++i) {
                all[i] = all[i] || shown[i];
            }
        }
        std::set<Region> reported;
        for (const auto& [decision, shown] : decisions) {
            const std::vector<Region> conditions = conditions_of(decision, decisions, branches);
            for (std::size_t i = 0; i < shown.size(); ++i) {
                made_.conditions.add({shown[i] ? 1U : 0U, 1});
                if (!shown[i] && !is_silent(decision.line)) {
                    const bool known = conditions.size() == shown.size();
                    const Region place = known ? conditions[i] : decision;
                    add_gap("condition", place.line, text_of(place, lines_),
                            known ? "not shown to decide alone" : fmt::format("condition {} of the decision", i + 1));
                    reported.insert(place);
                }
            }
        }
        return reported;
    }

    /// Returns the branches (the conditions) of a decision, without those of a decision nested in it.
    static std::vector<Region> conditions_of(const Region& decision,
                                             const std::map<Region, std::vector<bool>>& decisions,
                                             const std::map<Region, Ways>& branches) {
        std::vector<Region> conditions;
        for (const auto& branch : branches) {
            const Region& place = branch.first;
            const bool inner = std::any_of(decisions.begin(), decisions.end(), [&](const auto& other) {
                return decision.holds(other.first) && !other.first.holds(decision) && other.first.holds(place);
            });
            if (decision.holds(place) && !inner) {
                conditions.push_back(place);
            }
        }
        return conditions;
    }

    const nlohmann::json& source_;
    std::vector<std::string> lines_;
    std::vector<Region> silent_;  ///< bodies of functions that were never called
    FileCoverage made_;
};

/// Returns a name without template arguments, because all instantiations of a template count together.
std::string without_arguments(const std::string& name) {
    std::string plain;
    int depth = 0;
    for (const char letter : name) {
        depth += letter == '<' ? 1 : 0;
        if (depth == 0) {
            plain += letter;
        }
        depth -= letter == '>' ? 1 : 0;
    }
    return plain;
}

/// Returns the readable form of a mangled name, such as `canproof::Node::receive`. llvm-cov puts `file:` before names
/// that are local to a file.
std::string readable(std::string name) {
    name = name.substr(name.rfind(':') == std::string::npos ? 0 : name.rfind(':') + 1);
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> text{abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                      std::free};
    std::string plain = status == 0 ? text.get() : name;
    const std::string hidden = "(anonymous namespace)::";
    for (auto at = plain.find(hidden); at != std::string::npos; at = plain.find(hidden)) {
        plain.erase(at, hidden.size());
    }
    if (plain.find("operator") != std::string::npos) {
        return plain.substr(0, plain.find('('));
    }
    plain = without_arguments(plain);
    plain = plain.substr(0, plain.find('('));
    return plain.substr(plain.find_last_of(' ') + 1);  // removes the return type of a template
}

using Functions = std::map<std::string, std::map<Region, std::pair<unsigned long long, std::string>>>;

/// Returns the executions and the name of each function, by file and region of the body.
Functions functions_of(const nlohmann::json& data) {
    Functions all;
    for (const auto& function : data.at("functions")) {
        const nlohmann::json& regions = function.at("regions");
        if (regions.empty()) {
            continue;
        }
        auto& known = all[function.at("filenames").at(0)][region_of(regions.at(0))];
        known.first += function.at("count").get<unsigned long long>();
        known.second = readable(function.at("name"));
    }
    return all;
}

}  // namespace

std::vector<FileCoverage> read_coverage(const std::filesystem::path& file, const std::filesystem::path& root,
                                        const SourceAge age) {
    std::ifstream in{file};
    if (!std::filesystem::is_regular_file(file) || !in) {
        throw InputError{fmt::format(
            "there is no measurement {}; run tests/coverage, or `./run coverage` in your own project", file.string())};
    }
    std::vector<FileCoverage> files;
    try {
        const nlohmann::json document = nlohmann::json::parse(in);
        const nlohmann::json& data = document.at("data").at(0);
        const Functions functions = functions_of(data);
        for (const auto& source : data.at("files")) {
            const std::filesystem::path path = source.at("filename").get<std::string>();
            const std::string whole = path.generic_string();
            const std::string of_host = judged_host_path(whole);
            const std::string name = of_host.empty() ? firmware_path(whole) : of_host;
            if (name.empty()) {
                continue;
            }
            const auto known = functions.find(whole);
            files.push_back(FileReader{source, name, lines_of(root / name, file, age)}.read(
                known == functions.end() ? Functions::mapped_type{} : known->second));
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError{
            fmt::format("{} is no export of llvm-cov ({}); run tests/coverage again", file.string(), error.what())};
    }
    if (std::all_of(files.begin(), files.end(), [](const FileCoverage& one) { return one.is_host(); })) {
        throw InputError{fmt::format("{} measures no file of the firmware; run tests/coverage again", file.string())};
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
    return files;
}

}  // namespace canproof::host
