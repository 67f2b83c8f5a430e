// Sections and keys that CiA 306 knows, as it spells them.
#pragma once

#include <string>

namespace canproof::host {

/// The section as CiA 306 spells it, [1018sub1] and the like included; empty: CiA 306 has none.
std::string known_section(const std::string& name);

/// The key of a section as CiA 306 spells it; empty: CiA 306 has none there. Both in any case.
std::string known_key(const std::string& section, const std::string& key);

/// Keys of an object that only a device configuration file has.
bool is_dcf_key(const std::string& key);

}  // namespace canproof::host
