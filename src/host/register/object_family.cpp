// SPDX-License-Identifier: Apache-2.0
#include "host/register/object_family.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <string>

namespace canproof::host {

namespace {

constexpr std::int64_t most_step = 4096;

/// Returns the number whose hexadecimal digits are the decimal digits of `n`: 10h for 10. `n` has at most three digits.
std::int64_t decimal_digits(std::int64_t n) {
    return n / 100 * 256 + n / 10 % 10 * 16 + n % 10;
}

}  // namespace

std::int64_t ObjectFamily::offset(std::int64_t n) const {
    return (decimal ? decimal_digits(n) - decimal_digits(first) : n - first) * step;
}

ObjectFamily read_family(TomlItem& item) {
    ObjectFamily family;
    if (auto repeat = item.item("repeat")) {
        family.first = repeat->integer("first", 0, 255);
        family.last = repeat->integer("last", family.first, 255);
        family.step = repeat->integer("step", 1, most_step);
        family.decimal = repeat->boolean_or("decimal", false);
        repeat->finish();
    }
    return family;
}

void check_family_default(TomlItem& item, const FamilyMember& member) {
    const toml::node* node = item.node("default");
    const auto table = node == nullptr ? nullptr : node->as_table();
    if (table == nullptr) {
        return;
    }
    for (std::int64_t n = member.first; n <= member.last; ++n) {
        if (!table->contains(std::to_string(n))) {
            item.fault(item.place("default"), fmt::format("default gives no value for member {}", n),
                       fmt::format("add `{} = …`", n));
        }
    }
    for (const auto& [key, value] : *table) {
        const std::string word{key.str()};
        const bool number =
            !word.empty() && word.size() < 4 && word.find_first_not_of("0123456789") == std::string::npos;
        if (!number || std::stoll(word) < member.first || std::stoll(word) > member.last) {
            item.fault(item.place(value), fmt::format("default names member {}, which the family lacks", word),
                       fmt::format("use members {} to {}", member.first, member.last));
        }
    }
}

}  // namespace canproof::host
