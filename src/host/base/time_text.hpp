// SPDX-License-Identifier: Apache-2.0
// Times as text in logs and stimuli: seconds with up to six decimals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/base/time.hpp"

namespace canproof::host {

/// Parses a time in seconds such as `12.345678`: at most twelve digits before the point and six after it. Returns
/// nothing for any other text.
std::optional<Instant> seconds_of(std::string_view text);
/// Parses a time as seconds_of() does. Throws InputError for any other text; its message begins with `where`
/// ("file:line").
Instant parse_seconds(const std::string& text, const std::string& where);
/// Returns the time in seconds with exactly six decimals: `12.345678`.
std::string format_seconds(Instant time);
/// Appends to `text` what format_seconds() returns.
void append_seconds(std::string& text, Instant time);

}  // namespace canproof::host
