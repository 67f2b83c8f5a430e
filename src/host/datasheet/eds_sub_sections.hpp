// SPDX-License-Identifier: Apache-2.0
// The sections of a data sheet that describe single entries, such as [1018sub1].
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

/// Ascending by index and sub-index; each entry occurs once.
using SubSections = std::vector<SubSection>;

/// Collects the sections of all entries. Of several sections of one entry the first in the file counts; the others get
/// a note. `file` must outlive the result.
SubSections find_sub_sections(const IniFile& file, const EdsTelling& tell);

/// Returns the first section of an object's entries and the end of them.
std::pair<SubSections::const_iterator, SubSections::const_iterator> subs_of(const SubSections& all,
                                                                            std::uint16_t index);

}  // namespace canproof::host
