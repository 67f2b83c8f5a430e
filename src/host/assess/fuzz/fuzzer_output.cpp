// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/fuzzer_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <regex>
#include <sstream>

namespace canproof::host {

namespace {

constexpr std::size_t frames_of_a_title = 3;

std::optional<std::uint64_t> number_behind(const std::string& line, const std::string& word) {
    const auto at = line.find(word);
    if (at == std::string::npos) {
        return {};
    }
    std::uint64_t number = 0;
    std::istringstream in{line.substr(at + word.size())};
    return in >> number ? std::optional{number} : std::nullopt;
}

/// Returns the path relative to the project's folder: the end of `path` from src/, fuzz/, properties/ or tests/ on.
std::string project_path(const std::string& path) {
    for (const char* folder : {"/src/", "/fuzz/", "/properties/", "/tests/"}) {
        if (const auto at = path.rfind(folder); at != std::string::npos) {
            return path.substr(at + 1);
        }
    }
    return path;
}

/// Returns whether a function belongs to the code under test. Functions of the fuzzer, the sanitizers and the libraries
/// are left out of stack traces, because they do not distinguish bugs.
bool is_ours(const std::string& function) {
    for (const char* other : {"__", "fuzzer::", "abort", "raise", "gsignal", "pthread_", "_start", "main", "LLVMFuzzer",
                              "canproof::fuzz::require", "std::", "operator ", "mem", "killpg"}) {
        if (function.rfind(other, 0) == 0) {
            return false;
        }
    }
    return function.find("::require(") == std::string::npos;
}

/// Returns the name of the function without its parameters: `canproof::f<int>` for `canproof::f<int>(char) const`.
std::string without_arguments(std::string function) {
    const std::string nameless = "(anonymous namespace)::";
    for (auto at = function.find(nameless); at != std::string::npos; at = function.find(nameless)) {
        function.erase(at, nameless.size());
    }
    return function.substr(0, function.find('('));
}

std::string kind_of(const std::string& output) {
    std::smatch found;
    static const std::regex sanitizer{R"(ERROR: \w+Sanitizer: ([\w-]+))"};
    static const std::regex undefined{R"(runtime error: ([^\n]*))"};
    static const std::regex fuzzer{R"(ERROR: libFuzzer: ([\w-]+))"};
    static const std::regex valgrind{
        R"(==\d+== ((?:Conditional jump|Use of uninit|Invalid (?:read|write)|Syscall param)[^\n]*))"};
    if (output.find("requirement violated at ") != std::string::npos) {
        return "requirement violated";
    }
    if (std::regex_search(output, found, undefined)) {
        static const std::regex numbers{R"(-?\b(0x[0-9a-fA-F]+|\d+)\b)"};
        return std::regex_replace(found[1].str(), numbers, "N");
    }
    if (std::regex_search(output, found, sanitizer) || std::regex_search(output, found, fuzzer) ||
        std::regex_search(output, found, valgrind)) {
        return found[1];
    }
    return "unknown";
}

}  // namespace

std::optional<FuzzerProgress> parse_progress(const std::string& line) {
    if (line.empty() || line[0] != '#') {
        return {};
    }
    const auto executions = number_behind(line, "#");
    const auto edges = number_behind(line, " cov: ");
    const auto features = number_behind(line, " ft: ");
    if (!executions || !edges || !features) {
        return {};
    }
    return FuzzerProgress{*executions, *edges, *features};
}

std::string Failure::title() const {
    if (!place.empty()) {
        return fmt::format("{} at {}", kind, place);
    }
    const auto shown = std::min(frames.size(), frames_of_a_title);
    return frames.empty()
               ? kind
               : fmt::format("{} in {}", kind,
                             fmt::join(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(shown), " < "));
}

std::string Failure::signature() const {
    std::uint32_t hash = 2166136261U;  // start value of the FNV-1a hash
    for (const char c : title()) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    }
    return fmt::format("{:08x}", hash);
}

Failure parse_failure(const std::string& output) {
    Failure failure;
    failure.kind = kind_of(output);
    std::smatch found;
    static const std::regex requirement{R"(requirement violated at (\S+))"};
    if (std::regex_search(output, found, requirement)) {
        failure.place = project_path(found[1]);
    }
    static const std::regex frame{
        R"(^(?:    #\d+ 0x[0-9a-f]+ in|==\d+==    (?:at|by) 0x[0-9A-F]+:) (.*?)(?: \(in [^)]*\)| \([\w.]+:\d+\)| [/.]\S*| \(\S*\+0x\S*\).*)?$)"};
    std::istringstream lines{output};
    bool open = false;
    for (std::string line; std::getline(lines, line);) {
        const bool matches = std::regex_match(line, found, frame);
        if (open && !matches) {
            // the first stack trace is that of the failure; later ones show other places, such as that of an allocation
            break;
        }
        if (matches && is_ours(found[1])) {
            failure.frames.push_back(without_arguments(found[1]));
        }
        open = matches;
    }
    return failure;
}

}  // namespace canproof::host
