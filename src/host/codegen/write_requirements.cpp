// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/write_requirements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace canproof::host {

namespace {

std::string id_type(const Item& item, const std::string& word) {
    std::string name = item.id;
    std::replace(name.begin(), name.end(), '-', '_');
    return fmt::format(
        "struct {} {{ static constexpr bool in_force = true; static constexpr const char* id = \"{}\"; }};  // {} in "
        "{}\n",
        name, item.id, word, item.place.file);
}

}  // namespace

std::string write_requirements(const Register& content, const Part& part) {
    std::string text =
        "// Written by canproof's speccompiler from spec/: a type for each id of this part in force, for "
        "implements<>\n// and verifies<>. Retired ids have no type.\n#pragma once\n\nnamespace canproof::req {\n\n";
    std::set<std::string> retired;
    for (const Requirement& requirement : part.requirements) {
        if (!requirement.retired.empty()) {
            retired.insert(requirement.id);
        }
    }
    content.for_each_item(part, [&](const Item& item, const char* word) {
        if (retired.count(item.id) == 0) {
            text += id_type(item, word);
        }
    });
    for (const Decision& decision : part.decisions) {
        text += id_type(decision, "decision");
    }
    return text + "\n}  // namespace canproof::req\n";
}

}  // namespace canproof::host
