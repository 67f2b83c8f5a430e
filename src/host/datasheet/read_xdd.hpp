// SPDX-License-Identifier: Apache-2.0
// Reads a device description in XML (CiA 311, 1.0 and 1.1) into the corresponding sections and keys of CiA 306.
#pragma once

#include <string>

#include "host/datasheet/ini.hpp"

namespace canproof::host {

/// Returns whether the text is XML: its first character after a byte order mark and blanks is `<`.
bool is_xml(const std::string& text);

/// Returns the sections of the device description. Adds a fault when the text is no such description. Defects of single
/// elements are found later, when the sections are read.
IniFile read_xdd(const std::string& text, const EdsTelling& tell);

}  // namespace canproof::host
