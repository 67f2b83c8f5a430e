// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/link_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "host/assess/source/cpp_text.hpp"
#include "host/base/lines.hpp"

namespace canproof::host {

namespace {

const std::string link_start = "static_assert(implements<";

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(' ');
    return first == std::string::npos ? "" : line.substr(first);
}

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

std::size_t links_of(const std::string& line) {
    static const std::string link = "implements<req::";
    const auto comment = line.find("//");
    std::size_t count = 0;
    for (auto at = line.find(link); at < comment; at = line.find(link, at + link.size())) {
        ++count;
    }
    return count;
}

/// Returns whether the line below a link (an implements<> assertion) can implement something. Empty lines, the start or
/// end of a block, access specifiers, aliases and similar code cannot.
bool can_do(const std::string& code) {
    static const std::array<std::string, 12> others{{"}", "{", "#", "namespace ", "using ", "friend ", "public:",
                                                     "protected:", "private:", "case ", "default:", "break;"}};
    return !code.empty() &&
           std::none_of(others.begin(), others.end(), [&](const auto& other) { return begins(code, other); });
}

/// Returns whether a declaration is that of a function. `head` is its text up to the body or the semicolon.
bool declares_function(const std::string& head) {
    const auto first = head.find_first_of("(=");
    return first != std::string::npos && (head[first] == '(' || head.find("operator") < first);
}

/// Returns for each line whether the line begins inside the body of a function. `code` must have neither comments nor
/// literals.
std::vector<bool> inside_functions(const std::vector<std::string>& code) {
    std::vector<bool> inside;
    std::vector<bool> blocks;  // whether each open block is in a function; the outermost block is first
    std::string head;          // text of the unfinished declaration or statement so far
    for (const auto& line : code) {
        const bool in_function = !blocks.empty() && blocks.back();
        inside.push_back(in_function);
        for (const char c : line) {
            if (c == '{') {
                blocks.push_back((!blocks.empty() && blocks.back()) || declares_function(head));
            } else if (c == '}' && !blocks.empty()) {
                blocks.pop_back();
            }
            head = c == '{' || c == '}' || c == ';' ? "" : head + c;
        }
    }
    return inside;
}

/// Returns whether line `at` is outside of all functions and a function begins there.
bool begins_function(const std::vector<std::string>& code, std::size_t at) {
    std::string head;
    for (; at < code.size() && head.find_first_of("{;") == std::string::npos; ++at) {
        head += code[at] + " ";
    }
    return declares_function(head.substr(0, head.find_first_of("{;")));
}

}  // namespace

std::vector<std::string> misplaced_in(const std::string& name, const std::vector<std::string>& lines) {
    std::vector<std::string> all;
    const std::vector<std::string> code_lines = split_lines(code_only(fmt::format("{}\n", fmt::join(lines, "\n"))));
    const std::vector<bool> inside_function = inside_functions(code_lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!begins(trimmed(lines[i]), link_start)) {
            continue;
        }
        const std::size_t first = i + 1;
        std::size_t links = 0;
        bool inside = false;  // whether the line belongs to a statement that an earlier line has begun
        for (; i < lines.size(); ++i) {
            const std::string code = trimmed(lines[i]);
            if (!inside && !begins(code, link_start) && !begins(code, "//")) {
                break;
            }
            links += links_of(code);
            inside = !begins(code, "//") && code.back() != ';';
        }
        if (links > most_links) {
            all.push_back(
                fmt::format("{}:{}: implements<> names {} items in one place, but at most {} may be named; name each "
                            "item above its code",
                            name, first, links, most_links));
        }
        if (i == lines.size() || !can_do(trimmed(lines[i]))) {
            all.push_back(fmt::format(
                "{}:{}: no code follows that can implement the item; put implements<> directly above the code", name,
                first));
        } else if (!inside_function[i] && !begins_function(code_lines, i)) {
            all.push_back(fmt::format(
                "{}:{}: the code below implements<> is no function; put implements<> directly above the function "
                "that implements the item",
                name, first));
        }
    }
    return all;
}

std::vector<std::string> misplaced_links(const std::filesystem::path& root) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    if (fs::is_directory(root / "src")) {
        for (const auto& file : fs::recursive_directory_iterator(root / "src")) {
            const auto ending = file.path().extension();
            if (file.is_regular_file() && (ending == ".hpp" || ending == ".cpp")) {
                files.push_back(file.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> all;
    for (const auto& file : files) {
        const auto found = misplaced_in(file.lexically_relative(root).generic_string(), read_lines(file));
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

}  // namespace canproof::host
