// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_sub_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

/// Returns the entry that a section describes by its name, such as `1018sub1`; nothing for any other name.
std::optional<SubSection> sub_section(std::string_view name, const IniSection& section) {
    const auto sub = name.find("sub");
    if (sub == std::string_view::npos || sub == 0 || sub > 4) {
        return std::nullopt;
    }
    const auto index = eds_hexadecimal(name.substr(0, sub));
    const auto number = eds_hexadecimal(name.substr(sub + 3));
    if (!index || !number || *index > 0xFFFFU || *number > last_subindex) {
        return std::nullopt;
    }
    return SubSection{static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*number), &section};
}

bool is_same_entry(const SubSection& a, const SubSection& b) {
    return a.index == b.index && a.subindex == b.subindex;
}

}  // namespace

SubSections find_sub_sections(const IniFile& file, const EdsTelling& tell) {
    SubSections all;
    for (const auto& [name, section] : file.sections()) {
        if (const auto found = sub_section(name, section)) {
            all.push_back(*found);
        }
    }
    const auto goes_before = [](const SubSection& a, const SubSection& b) {
        return std::tie(a.index, a.subindex, a.section->line) < std::tie(b.index, b.subindex, b.section->line);
    };
    if (!std::is_sorted(all.begin(), all.end(), goes_before)) {
        std::sort(all.begin(), all.end(), goes_before);
    }
    SubSections once;
    for (const SubSection& one : all) {
        if (once.empty() || !is_same_entry(once.back(), one)) {
            once.push_back(one);
        } else {
            tell.note(
                one.section->line,
                fmt::format("[{}] describes the same entry as [{}]", one.section->name, once.back().section->name),
                "the first counts");
        }
    }
    return once;
}

std::pair<SubSections::const_iterator, SubSections::const_iterator> subs_of(const SubSections& all,
                                                                            std::uint16_t index) {
    const auto before = [](const SubSection& one, unsigned number) { return one.index < number; };
    return {std::lower_bound(all.begin(), all.end(), unsigned{index}, before),
            std::lower_bound(all.begin(), all.end(), unsigned{index} + 1U, before)};
}

}  // namespace canproof::host
