// CiA 311: a device description in XML, 1.0 and 1.1, as the sections and keys that CiA 306 has for the same.
#pragma once

#include <string>

#include "host/datasheet/ini.hpp"

namespace canproof::host {

/// XML begins with `<`; no line of an EDS does.
bool is_xml(const std::string& text);

/// What is wrong with its elements is told by whoever reads the sections; what is no description at all is a fault.
IniFile read_xdd(const std::string& text, const EdsTelling& tell);

}  // namespace canproof::host
