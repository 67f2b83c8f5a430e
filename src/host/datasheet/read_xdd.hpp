// SPDX-License-Identifier: Apache-2.0
// Reads a device description in XML (CiA 311, 1.0 and 1.1) as the corresponding sections and keys of CiA 306.
#pragma once

#include <string>

#include "host/datasheet/ini.hpp"

namespace canproof::host {

/// Each of the following functions returns an edit of one line.
bool is_xml(const std::string& text);

/// Returns the sections. A text that is no device description is a fault; the reader of the sections reports defects of
/// single elements.
IniFile read_xdd(const std::string& text, const EdsTelling& tell);

}  // namespace canproof::host
