// Times as logs and stimuli write them: seconds with up to six decimals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/base/time.hpp"

namespace canproof::host {

/// `12.345678` (seconds) as a time, at most twelve digits before the point; nothing when it is none.
std::optional<Instant> seconds_of(std::string_view text);
/// As seconds_of(). Throws InputError, which names `where` ("file:line").
Instant parse_seconds(const std::string& text, const std::string& where);
/// `12.345678`, always with six decimals.
std::string format_seconds(Instant time);
/// The same, behind what stands in `text`.
void append_seconds(std::string& text, Instant time);

}  // namespace canproof::host
