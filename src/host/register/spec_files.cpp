// SPDX-License-Identifier: Apache-2.0
#include "host/register/spec_files.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

SpecFiles read_spec_files(const std::filesystem::path& spec) {
    SpecFiles files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(spec)) {
        const std::string path = "spec/" + file.path().lexically_relative(spec).generic_string();
        const bool is_hidden = file.path().filename().string().front() == '.';  // for example the lock of an editor
        if (is_hidden || file.is_directory() || file.path().extension() != ".toml" ||
            path.rfind(conformance_cases, 0) == 0) {
            continue;
        }
        files[path] = read_file(file.path(), longest_toml_file);
    }
    if (files.empty()) {
        throw InputError{
            fmt::format("{} contains no .toml file; name the folder of a register, such as spec", spec.string())};
    }
    return files;
}

SpecFiles with_shared_rules(SpecFiles own, const SpecFiles& package) {
    const auto first = own.lower_bound(shared_rules);
    if (first != own.end() && first->first.rfind(shared_rules, 0) == 0) {
        return own;
    }
    for (const auto& [path, text] : package) {
        if (path.rfind(shared_rules, 0) == 0) {
            own.emplace(from_package + path, text);
        } else if (path.rfind(from_package + shared_rules, 0) == 0) {
            own.emplace(path, text);
        }
    }
    return own;
}

}  // namespace canproof::host
