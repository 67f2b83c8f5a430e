// SPDX-License-Identifier: Apache-2.0
// Sections and keys of CiA 306 in its spelling.
#pragma once

#include <string>
#include <string_view>

namespace canproof::host {

/// Returns the section in the spelling of CiA 306, also for [1018sub1] and similar names; empty when CiA 306 has none.
std::string known_section(const std::string& name);

/// Returns the key of a section in the spelling of CiA 306; empty when the section has no such key. The case of both
/// names does not matter.
std::string known_key(const std::string& section, std::string_view key);

/// Returns whether the key of an object exists only in device configuration files.
bool is_dcf_key(std::string_view key);

}  // namespace canproof::host
