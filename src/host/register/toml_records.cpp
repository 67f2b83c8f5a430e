// SPDX-License-Identifier: Apache-2.0
#include "host/register/toml_records.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/register/toml_depth.hpp"

namespace canproof::host {

void read_toml_records(const std::filesystem::path& file, const std::function<void(TomlItem&)>& read) {
    Faults faults;
    const std::string text = read_file(file, longest_toml_file);
    if (const auto line = too_deep_in(text)) {
        throw InputError{
            fmt::format("{}:{}: keys or values go more than {} levels deep; write shorter keys and fewer brackets",
                        file.string(), *line, deepest_toml)};
    }
    try {
        const toml::table table = toml::parse(text, file.string());
        TomlItem whole{table, file.string(), faults};
        read(whole);
        whole.finish();
    } catch (const toml::parse_error& error) {
        faults.emplace_back(Place{file.string(), static_cast<unsigned>(error.source().begin.line)},
                            std::string{error.description()}, "fix the TOML");
    }
    if (!faults.empty()) {
        throw InputError{faults.front().text()};
    }
}

}  // namespace canproof::host
