// SPDX-License-Identifier: Apache-2.0
#include "host/register/parse_file.hpp"

#include <fmt/format.h>

#include "host/register/toml_depth.hpp"

namespace canproof::host {

void parse_file(const std::string& path, const std::string& text, Faults& faults,
                const std::function<void(const toml::table&)>& read) {
    if (const auto line = too_deep_in(text)) {
        faults.emplace_back({path, *line}, fmt::format("keys or values go more than {} levels deep", deepest_toml),
                            "write shorter keys and fewer brackets");
        return;
    }
    try {
        read(toml::parse(text, path));
    } catch (const toml::parse_error& error) {
        faults.emplace_back({path, static_cast<unsigned>(error.source().begin.line)},
                            fmt::format("the file is not TOML: {}", error.description()),
                            "correct the syntax; until then, no fault of other kinds is reported");
    }
}

Faults syntax_faults(const SpecFiles& files) {
    Faults faults;
    for (const auto& [path, text] : files) {
        parse_file(path, text, faults, [](const toml::table&) {});
    }
    return faults;
}

}  // namespace canproof::host
