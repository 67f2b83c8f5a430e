// SPDX-License-Identifier: Apache-2.0
// Finds the sections of a data sheet that describe single entries, such as [1018sub1].
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "host/datasheet/ini.hpp"

namespace canproof::host {

constexpr unsigned last_subindex = 0xFE;  ///< highest sub-index of an entry

struct SubSection {
    std::uint16_t index{0};
    std::uint8_t subindex{0};
    const IniSection* section{nullptr};
};

/// Sections in ascending order of index and sub-index; there is one for each entry.
using SubSections = std::vector<SubSection>;

/// Collects the sections of all entries. If an entry has several sections, uses the first in the file and adds a note
/// for each other one. `file` must outlive the result.
SubSections find_sub_sections(const IniFile& file, const EdsTelling& tell);

/// Returns the range of the sections that describe an object's entries.
std::pair<SubSections::const_iterator, SubSections::const_iterator> subs_of(const SubSections& all,
                                                                            std::uint16_t index);

}  // namespace canproof::host
