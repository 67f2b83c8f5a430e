// SPDX-License-Identifier: Apache-2.0
#include "host/assess/source/cpp_text.hpp"

#include <algorithm>
#include <cctype>

namespace canproof::host {

namespace {

/// Returns the position after the literal that begins at `at`.
std::size_t literal_end(const std::string& text, std::size_t at) {
    if (at > 0 && text[at] == '"' && text[at - 1] == 'R') {
        const std::string end = ")" + text.substr(at + 1, text.find('(', at) - at - 1) + "\"";
        const auto found = text.find(end, at);
        return found == std::string::npos ? text.size() : found + end.size();
    }
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != text[at] && text[end] != '\n') {
        end += text[end] == '\\' ? 2U : 1U;
    }
    return std::min(end + 1, text.size());
}

/// Returns the position after the comment that begins at `at`; returns `at` when no comment begins there.
std::size_t comment_end(const std::string& text, std::size_t at) {
    if (text.compare(at, 2, "//") == 0) {
        return std::min(text.find('\n', at), text.size());
    }
    if (text.compare(at, 2, "/*") == 0) {
        const auto end = text.find("*/", at + 2);
        return end == std::string::npos ? text.size() : end + 2;
    }
    return at;
}

/// Returns whether a literal begins at `at`. An apostrophe between the digits of a number begins no literal.
bool begins_literal(const std::string& text, std::size_t at) {
    return text[at] == '"' || (text[at] == '\'' && (at == 0 || !is_word(text[at - 1])));
}

}  // namespace

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string code_only(const std::string& source) {
    std::string text = source;
    const auto blank = [&text](std::size_t from, std::size_t to) {
        std::replace_if(
            text.begin() + static_cast<std::ptrdiff_t>(from), text.begin() + static_cast<std::ptrdiff_t>(to),
            [](char c) { return c != '\n'; }, ' ');
    };
    for (std::size_t at = 0; at < source.size();) {
        if (const auto end = comment_end(source, at); end != at) {
            blank(at, end);
            at = end;
        } else if (begins_literal(source, at)) {
            const auto last = literal_end(source, at);
            blank(at, last);
            at = last;
        } else {
            ++at;
        }
    }
    return text;
}

std::string without_layout(const std::string& source) {
    std::string text;
    for (std::size_t at = 0; at < source.size();) {
        const char c = source[at];
        if (const auto end = comment_end(source, at); end != at) {
            at = end;
        } else if (begins_literal(source, at)) {
            const auto last = literal_end(source, at);
            text += source.substr(at, last - at);
            at = last;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            // Keeps one space between two words and removes all other spaces.
            const auto next = std::min(source.find_first_not_of(" \t\r\n", at), source.size());
            if (!text.empty() && is_word(text.back()) && next < source.size() && is_word(source[next])) {
                text += ' ';
            }
            at = next;
        } else {
            text += c;
            ++at;
        }
    }
    return text;
}

std::size_t block_end(const std::string& text, std::size_t at) {
    std::size_t depth = 0;
    while (at < text.size()) {
        if (begins_literal(text, at)) {
            at = literal_end(text, at);
            continue;
        }
        const char c = text[at];
        ++at;
        depth += c == '{' ? 1U : 0U;
        if (c == '}' && depth > 0 && --depth == 0) {
            return at;
        }
    }
    return text.size();
}

}  // namespace canproof::host
