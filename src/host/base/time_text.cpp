#include "host/base/time_text.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t micros = 1000000;

bool is_decimal(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::optional<Instant> seconds_of(const std::string& text) {
    const auto point = text.find('.');
    const std::string whole = text.substr(0, point);
    std::string fraction = point == std::string::npos ? "0" : text.substr(point + 1);
    if (!is_decimal(whole) || whole.size() > 12 || !is_decimal(fraction) || fraction.size() > 6) {
        return std::nullopt;
    }
    fraction.resize(6, '0');
    return Instant{std::stoull(whole) * micros + std::stoull(fraction)};
}

Instant parse_seconds(const std::string& text, const std::string& where) {
    const std::optional<Instant> time = seconds_of(text);
    if (!time) {
        throw InputError{
            fmt::format("{}: `{}` is no time in seconds with up to six decimals; write it as 12.345678", where, text)};
    }
    return *time;
}

std::string format_seconds(Instant time) {
    return fmt::format("{}.{:06}", time.us / micros, time.us % micros);
}

}  // namespace canproof::host
