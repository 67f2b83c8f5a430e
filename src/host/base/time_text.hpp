// Times as logs and stimuli write them: seconds with up to six decimals.
#pragma once

#include <optional>
#include <string>

#include "firmware/base/time.hpp"

namespace canproof::host {

/// `12.345678` (seconds) as a time, at most twelve digits before the point; nothing when it is none.
std::optional<Instant> seconds_of(const std::string& text);
/// As seconds_of(). Throws InputError, which names `where` ("file:line").
Instant parse_seconds(const std::string& text, const std::string& where);
/// `12.345678`, always with six decimals.
std::string format_seconds(Instant time);

}  // namespace canproof::host
