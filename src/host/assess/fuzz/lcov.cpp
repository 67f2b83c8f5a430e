// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/lcov.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "host/assess/firmware_scope.hpp"

namespace canproof::host {

namespace {

/// Returns the demangled name of a function with its parameter types; the name itself when it is not mangled.
std::string demangled(const std::string& name) {
    // llvm-cov puts the file before a function in an anonymous namespace: `file.cpp:_ZN…`.
    const auto colon = name.rfind(':');
    const std::string symbol = colon == std::string::npos ? name : name.substr(colon + 1);
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> text{abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                      std::free};
    return status == 0 ? text.get() : symbol;
}

/// Returns line numbers as ranges: `12-15, 30`.
std::string ranges_of(const std::set<unsigned>& lines) {
    std::string text;
    for (auto at = lines.begin(); at != lines.end();) {
        const unsigned first = *at;
        unsigned last = first;
        for (++at; at != lines.end() && *at == last + 1; ++at) {
            last = *at;
        }
        text += fmt::format("{}{}{}", text.empty() ? "" : ", ", first, last == first ? "" : fmt::format("-{}", last));
    }
    return text;
}

/// The lcov records of one source file.
struct Source {
    std::map<unsigned, bool> lines;
    std::map<std::string, bool> functions;
};

}  // namespace

std::vector<FileLines> read_lcov(const std::string& text) {
    std::map<std::string, Source> sources;
    Source* source = nullptr;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) {
        const std::string kind = line.substr(0, line.find(':'));
        const std::string rest = line.size() > kind.size() ? line.substr(kind.size() + 1) : "";
        const auto comma = rest.find(',');
        if (kind == "SF") {
            const std::string path = firmware_path(rest);
            source = path.empty() ? nullptr : &sources[path];
        } else if (source != nullptr && kind == "DA" && comma != std::string::npos) {
            bool& hit = source->lines[static_cast<unsigned>(std::stoul(rest))];
            hit = hit || std::stod(rest.substr(comma + 1)) > 0.0;
        } else if (source != nullptr && kind == "FNDA" && comma != std::string::npos) {
            bool& hit = source->functions[demangled(rest.substr(comma + 1))];
            hit = hit || std::stod(rest) > 0.0;
        }
    }
    std::vector<FileLines> files;
    for (const auto& [path, one] : sources) {
        FileLines file{path, one.lines.size(), 0, "", {}};
        std::set<unsigned> unreached;
        for (const auto& [number, hit] : one.lines) {
            file.hit += hit ? 1U : 0U;
            if (!hit) {
                unreached.insert(number);
            }
        }
        file.unreached = ranges_of(unreached);
        for (const auto& [name, hit] : one.functions) {
            if (!hit) {
                file.functions.push_back(name);
            }
        }
        files.push_back(std::move(file));
    }
    return files;
}

}  // namespace canproof::host
