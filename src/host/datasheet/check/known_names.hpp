// SPDX-License-Identifier: Apache-2.0
// The sections and keys that CiA 306 defines, in the spelling of CiA 306.
#pragma once

#include <string>
#include <string_view>

namespace canproof::host {

/// Returns the section's name in the spelling of CiA 306, also for names such as [1018sub1]. Returns an empty text when
/// CiA 306 has no such section. Also accepts [DeviceCommissioning], with two m.
std::string known_section(const std::string& name);

/// Returns a key of a section in the spelling of CiA 306; an empty text when CiA 306 does not give the section this
/// key. Returns a key of an unknown section unchanged. Upper and lower case of `section` and `key` do not matter.
std::string known_key(const std::string& section, std::string_view key);

/// Returns whether the key of an object exists only in device configuration files.
bool is_dcf_key(std::string_view key);

}  // namespace canproof::host
