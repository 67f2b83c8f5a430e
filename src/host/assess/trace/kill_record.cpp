#include "host/assess/trace/kill_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <sstream>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/reading.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

const char* const heading = "test,body,kills,without mutants";
constexpr std::size_t hash_digits = 16;

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in{text};
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

/// The end of a literal that begins at `at`.
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

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The end of a comment that begins at `at`, or `at`.
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

/// The end of the block in braces that is the first one after `at`.
std::size_t block_end(const std::string& text, std::size_t at) {
    std::size_t depth = 0;
    while (at < text.size()) {
        const char c = text[at];
        if (c == '"' || (c == '\'' && !is_word(text[at - 1]))) {
            at = literal_end(text, at);
            continue;
        }
        ++at;
        depth += c == '{' ? 1U : 0U;
        if (c == '}' && --depth == 0) {
            return at;
        }
    }
    return text.size();
}

/// `Suite,Name` for Suite.Name and for One/Suite.Name/3, an instance of a test with parameters.
std::string defined_as(const std::string& test) {
    const auto dot = test.find('.');
    const std::string suite = test.substr(0, dot);
    const std::string name = dot == std::string::npos ? "" : test.substr(dot + 1);
    const auto slash = suite.find('/');
    return (slash == std::string::npos ? suite : suite.substr(slash + 1)) + "," + name.substr(0, name.find('/'));
}

}  // namespace

KillRecord read_kill_record(const std::filesystem::path& file) {
    KillRecord record;
    if (!std::filesystem::exists(file)) {
        return record;
    }
    std::istringstream in{read_file(file)};
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (number == 1 && line == heading) {
            continue;
        }
        const auto fields = parts_of(line + ",.", ',');
        if (fields.size() != 5 || fields[0].empty() || fields[1].empty()) {
            throw InputError{
                fmt::format("{}:{}: no line `{}`; run `canproof mutate --kills`", file.string(), number, heading)};
        }
        record[fields[0]] = {fields[1], parts_of(fields[2], ' '), parts_of(fields[3], ' ')};
    }
    return record;
}

std::string write_kill_record(const KillRecord& record) {
    std::string text = std::string{heading} + "\n";
    for (const auto& [test, line] : record) {
        text += fmt::format("{},{},{},{}\n", test, line.body, fmt::join(line.kills, " "),
                            fmt::join(line.without_mutants, " "));
    }
    return text;
}

std::string without_layout(const std::string& source) {
    std::string text;
    for (std::size_t at = 0; at < source.size();) {
        const char c = source[at];
        if (const auto end = comment_end(source, at); end != at) {
            at = end;
        } else if (c == '"' || (c == '\'' && (at == 0 || !is_word(source[at - 1])))) {
            const auto last = literal_end(source, at);
            text += source.substr(at, last - at);
            at = last;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            // Between two words one space stays.
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

std::string TestBodies::hash(const std::string& file, const std::string& test) {
    auto found = sources_.find(file);
    if (found == sources_.end()) {
        const auto path = root_ / file;
        const bool is_there = !file.empty() && std::filesystem::is_regular_file(path);
        found = sources_.emplace(file, is_there ? without_layout(read_file(path)) : "").first;
    }
    const std::string& text = found->second;
    for (const char* end : {")", ","}) {  // RC_GTEST_PROP(Suite, Name, (parameters))
        const auto at = text.find("(" + defined_as(test) + end);
        if (at != std::string::npos) {
            return sha256(text.substr(at, block_end(text, at) - at)).substr(0, hash_digits);
        }
    }
    return "";
}

}  // namespace canproof::host
