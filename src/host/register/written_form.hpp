// SPDX-License-Identifier: Apache-2.0
// The written forms of dates, hashes and names in the register.
#pragma once

#include <string>

namespace canproof::host {

/// Returns whether the text is a day of the calendar in the form YYYY-MM-DD.
bool is_date(const std::string& text);
/// Returns whether the text is a hash of an item, its code or its tests: 8 hexadecimal digits in lower case.
bool is_hash(const std::string& text);
/// Returns whether the text has printable ASCII characters only. An EDS can contain no others.
bool is_printable_ascii(const std::string& text);

}  // namespace canproof::host
