// SPDX-License-Identifier: Apache-2.0
#include "host/assess/source/linked_function.hpp"

#include <algorithm>
#include <array>

namespace canproof::host {

namespace {

/// Returns the number of opening braces minus the number of closing braces.
int depth_of(const std::string& line) {
    return static_cast<int>(std::count(line.begin(), line.end(), '{')) -
           static_cast<int>(std::count(line.begin(), line.end(), '}'));
}

/// Returns whether the line closes a block that was opened before the code under examination. `depth` is the number of
/// blocks that this code has opened and not closed.
bool closes_block_around(const std::string& line, int depth) {
    return std::any_of(line.begin(), line.end(), [&depth](char c) {
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        return depth < 0;
    });
}

/// Returns the position of the brace that opens the innermost block around the position `end`. Returns npos when there
/// is none.
std::size_t opening_before(const std::string& text, std::size_t end) {
    int depth = 0;
    for (std::size_t at = end; at > 0; --at) {
        depth += text[at - 1] == '{' ? 1 : text[at - 1] == '}' ? -1 : 0;
        if (depth > 0) {
            return at - 1;
        }
    }
    return std::string::npos;
}

/// Returns the position at which the head of a block begins, such as `if (…) `. The block opens at `open`.
std::size_t head_start(const std::string& text, std::size_t open) {
    int depth = 0;
    std::size_t at = open;
    for (; at > 0; --at) {
        const char c = text[at - 1];
        depth += c == ')' ? 1 : c == '(' ? -1 : 0;
        if (depth == 0 && (c == ';' || c == '{' || c == '}')) {
            break;
        }
    }
    return std::min(text.find_first_not_of(" \n", at), open);
}

/// Returns whether `head`, the text before a block, is that of a condition or a loop, not that of a function.
bool decides(const std::string& head) {
    static const std::array<const char*, 5> words{"if ", "else if ", "for ", "while ", "switch "};
    return std::any_of(words.begin(), words.end(), [&](const char* word) { return head.rfind(word, 0) == 0; });
}

std::size_t line_at(const std::string& text, std::size_t at) {
    return 1U +
           static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Returns the number of the line after the static_assert that begins at line `at`; returns `at` when none begins
/// there.
std::size_t behind_link(const std::vector<std::string>& lines, std::size_t at) {
    if (lines[at].find("static_assert(") == std::string::npos) {
        return at;
    }
    while (at < lines.size() && lines[at].find(';') == std::string::npos) {
        ++at;
    }
    return at + 1;
}

}  // namespace

LineRange function_below(const std::vector<std::string>& lines, std::size_t link) {
    std::size_t first = link == 0 ? lines.size() : link - 1;
    // `link` is a line with implements<>, which is part of a static_assert that may have several lines. This loop goes
    // to the last line of this static_assert.
    while (first < lines.size() && lines[first].find(';') == std::string::npos) {
        ++first;
    }
    ++first;
    for (std::size_t next = first; first < lines.size(); first = next) {
        next = behind_link(lines, first);
        if (next == first) {
            break;
        }
    }
    int depth = 0;
    bool opened = false;
    for (std::size_t at = first; at < lines.size(); ++at) {
        if (closes_block_around(lines[at], depth)) {
            return at == first ? LineRange{0, 0} : LineRange{first + 1, at};
        }
        depth += depth_of(lines[at]);
        opened = opened || lines[at].find('{') != std::string::npos;
        if (opened && depth <= 0) {
            return {first + 1, at + 1};
        }
    }
    return {0, 0};
}

LineRange condition_around(const std::vector<std::string>& lines, std::size_t link) {
    std::string before;
    for (std::size_t at = 0; at + 1 < link && at < lines.size(); ++at) {
        before += lines[at] + "\n";
    }
    for (std::size_t end = before.size(); end != 0 && end != std::string::npos;) {
        const std::size_t open = opening_before(before, end);
        if (open == std::string::npos) {
            break;
        }
        const std::size_t start = head_start(before, open);
        const std::string head = before.substr(start, open - start);
        if (head != "else ") {
            return decides(head) ? LineRange{line_at(before, start), line_at(before, open)} : LineRange{0, 0};
        }
        end = before.rfind('}', start);  // goes on with the block of the `if` to which this `else` belongs
    }
    return {0, 0};
}

}  // namespace canproof::host
