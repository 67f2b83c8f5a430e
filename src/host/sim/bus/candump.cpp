#include "host/sim/bus/candump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/base/time_text.hpp"

namespace canproof::host {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw InputError{
        fmt::format("{}: {}; a line of a candump log reads `(1.000000) can0 603#2B116401B33E0000`", where, what)};
}

bool all_of(const std::string& text, const char* allowed) {
    return text.find_first_not_of(allowed) == std::string::npos;
}

constexpr const char* hex_digits = "0123456789abcdefABCDEF";

/// By hand: a log has thousands of frames a second.
void append_hex(std::string& text, std::uint32_t value, unsigned digits) {
    for (unsigned left = digits; left > 0U; --left) {
        text += "0123456789ABCDEF"[(value >> (4U * (left - 1U))) & 0xFU];
    }
}

void read_data(Frame& frame, const std::string& data, const std::string& where) {
    if (data.size() % 2 != 0 || data.size() > 2 * max_frame_length || !all_of(data, hex_digits)) {
        refuse(where, fmt::format("data `{}` is not up to eight bytes in hexadecimal", data));
    }
    frame.length = static_cast<std::uint8_t>(data.size() / 2);
    for (std::size_t i = 0; i < frame.length; ++i) {
        frame.data[i] = static_cast<std::uint8_t>(std::stoul(data.substr(2 * i, 2), nullptr, 16));
    }
}

/// Classic CAN has codes from 9 to 15 for a length of eight as well: candump writes one of those behind `_`.
std::string without_length_code(const std::string& data, const std::string& where) {
    const auto at = data.find('_');
    if (at == std::string::npos) {
        return data;
    }
    const std::string code = data.substr(at + 1);
    const std::string rest = data.substr(0, at);
    const bool has_eight = rest.size() == 2 * max_frame_length || rest == "R8" || rest == "r8";
    if (!has_eight || code.size() != 1 || !all_of(code, "9ABCDEFabcdef")) {
        refuse(where, fmt::format("`_{}` is no length code from 9 to F behind eight bytes", code));
    }
    return rest;
}

}  // namespace

Frame parse_frame(const std::string& text, const std::string& where) {
    const auto hash = text.find('#');
    const std::string id = text.substr(0, hash);
    if (hash == std::string::npos || !all_of(id, hex_digits) || (id.size() != 3 && id.size() != 8)) {
        refuse(where, fmt::format("`{}` has no identifier of three or eight hexadecimal digits before #", text));
    }
    Frame frame{};
    frame.extended = id.size() == 8;
    frame.id = static_cast<std::uint32_t>(std::stoul(id, nullptr, 16));
    if (frame.id > (frame.extended ? 0x1FFFFFFFU : 0x7FFU)) {
        refuse(where, fmt::format("identifier {} is too large", id));
    }
    const std::string data = without_length_code(text.substr(hash + 1), where);
    if (data.find_first_of("Rr") == 0) {
        frame.remote = true;
        const std::string length = data.substr(1);
        if (length.size() > 1 || (length.size() == 1 && (length[0] < '0' || length[0] > '8'))) {
            refuse(where, fmt::format("`{}` is no length from 0 to 8 after R", length));
        }
        frame.length = length.empty() ? std::uint8_t{0} : static_cast<std::uint8_t>(length[0] - '0');
    } else {
        read_data(frame, data, where);
    }
    return frame;
}

namespace {

constexpr std::uint32_t error_flag = 0x20000000U;
constexpr std::uint32_t highest_identifier = 0x1FFFFFFFU;

/// `20000004#0000000000000000`: of the identifier one bit says that this is an error frame, others which.
bool is_error_frame(const std::string& frame) {
    const std::string id = frame.substr(0, frame.find('#'));
    return id.size() == 8 && id.size() < frame.size() && all_of(id, hex_digits) &&
           (std::stoul(id, nullptr, 16) & ~std::uint64_t{highest_identifier}) == error_flag;
}

LogMark mark_of(const std::string& word) {
    return word == "T" ? LogMark::transmitted : (word == "R" ? LogMark::received : LogMark::none);
}

}  // namespace

LoggedFrame parse_candump_line(const std::string& line, const std::string& where) {
    std::istringstream words{line};
    std::string time;
    LoggedFrame logged;
    std::string frame;
    std::string rest;
    words >> time >> logged.interface >> frame >> rest;
    if (frame.empty() || (!rest.empty() && rest != "R" && rest != "T")) {
        refuse(where, "not time, interface and frame");
    }
    if (time.size() < 3 || time.front() != '(' || time.back() != ')') {
        refuse(where, fmt::format("time `{}` does not stand in brackets", time));
    }
    const std::string seconds = time.substr(1, time.size() - 2);
    const std::optional<Instant> at = seconds_of(seconds);
    if (!at) {
        refuse(where, fmt::format("`{}` is no time in seconds with up to six decimals", seconds));
    }
    logged.time = *at;
    logged.mark = mark_of(rest);
    logged.error = is_error_frame(frame);
    if (logged.error) {
        read_data(logged.frame, frame.substr(frame.find('#') + 1), where);
        return logged;
    }
    logged.coded = frame.find('_') != std::string::npos;
    logged.frame = parse_frame(frame, where);
    return logged;
}

bool CandumpReader::next(LoggedFrame& frame) {
    while (lines_.next()) {
        if (lines_.line().find_first_not_of(" \t") == std::string::npos) {
            continue;
        }
        frame = parse_candump_line(lines_.line(), lines_.where());
        if (frame.time < last_) {
            throw InputError{fmt::format("{}: time goes backwards; sort the log by time", lines_.where())};
        }
        last_ = frame.time;
        counts_.coded_lengths += frame.coded ? 1U : 0U;
        if (!frame.error) {
            return true;
        }
        ++counts_.error_frames;
    }
    return false;
}

std::vector<LoggedFrame> read_candump_log(std::istream& in, const std::string& name) {
    CandumpReader reader{in, name};
    std::vector<LoggedFrame> log;
    for (LoggedFrame frame; reader.next(frame);) {
        log.push_back(frame);
    }
    return log;
}

std::string format_frame(const Frame& frame) {
    std::string text;
    append_hex(text, frame.id, frame.extended ? 8U : 3U);
    text += '#';
    if (frame.remote) {
        text += "R";
        if (frame.length > 0) {
            text += std::to_string(frame.length);
        }
        return text;
    }
    for (std::size_t i = 0; i < frame.length; ++i) {
        append_hex(text, frame.data[i], 2U);
    }
    return text;
}

std::string format_candump_line(const LoggedFrame& logged) {
    std::string line = "(" + format_seconds(logged.time) + ") ";
    return line.append(logged.interface).append(" ").append(format_frame(logged.frame));
}

}  // namespace canproof::host
