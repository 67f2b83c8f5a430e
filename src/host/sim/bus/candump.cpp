// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/candump.hpp"

#include <fmt/format.h>

#include <string_view>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/base/time_text.hpp"
#include "host/sim/bus/frame_text.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t longest_usual_line = 64;  // enough for `(1436509052.249713) vcan0 1FFFFFFF#0102030405060708`

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw InputError{
        fmt::format("{}: {}; a frame reads `603#2B116401B33E0000`; a line of a candump log reads `(1.000000) can0 "
                    "603#2B116401B33E0000`",
                    where, what)};
}

constexpr bool is_blank(char c) {
    return c <= ' ' && (c == ' ' || (c >= '\t' && c <= '\r'));
}

/// Removes and returns the next word of a line; empty when there is none.
std::string_view next_word(std::string_view& line) {
    std::size_t begin = 0;
    while (begin < line.size() && is_blank(line[begin])) {
        ++begin;
    }
    std::size_t end = begin;
    while (end < line.size() && !is_blank(line[end])) {
        ++end;
    }
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

LogMark mark_of(std::string_view word) {
    return word == "T" ? LogMark::transmitted : (word == "R" ? LogMark::received : LogMark::none);
}

TextFault read_time(std::string_view text, Instant& time) {
    if (text.size() < 3 || text.front() != '(' || text.back() != ')') {
        return fmt::format("the time `{}` is not in round brackets", text);
    }
    const std::string_view seconds = text.substr(1, text.size() - 2);
    const std::optional<Instant> at = seconds_of(seconds);
    if (!at) {
        return fmt::format("`{}` is no time in seconds with up to twelve digits and six decimals", seconds);
    }
    time = *at;
    return std::nullopt;
}

TextFault read_line(std::string_view line, LoggedFrame& logged) {
    const std::string_view time = next_word(line);
    const std::string_view interface = next_word(line);
    const std::string_view text = next_word(line);
    const std::string_view mark = next_word(line);
    if (text.empty() || (!mark.empty() && mark != "R" && mark != "T")) {
        return "the line does not consist of a time, an interface and a frame";
    }
    if (TextFault fault = read_time(time, logged.time)) {
        return fault;
    }
    if (logged.interface != interface) {  // in most logs all lines have the same interface
        logged.interface = interface;
    }
    logged.mark = mark_of(mark);
    FrameText read;
    TextFault fault = read_logged_frame(text, read);
    logged.frame = read.frame;
    logged.error = read.error;
    logged.coded = read.coded;
    return fault;
}

}  // namespace

Frame parse_frame(const std::string& text, const std::string& where) {
    FrameText read;
    if (const TextFault fault = read_frame_text(text, read)) {
        refuse(where, *fault);
    }
    return read.frame;
}

LoggedFrame parse_candump_line(const std::string& line, const std::string& where) {
    LoggedFrame logged;
    if (const TextFault fault = read_line(line, logged)) {
        refuse(where, *fault);
    }
    return logged;
}

bool CandumpReader::next(LoggedFrame& frame) {
    while (lines_.next()) {
        if (lines_.line().find_first_not_of(" \t") == std::string::npos) {
            continue;
        }
        if (const TextFault fault = read_line(lines_.line(), frame)) {
            refuse(lines_.where(), *fault);
        }
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
    append_frame(text, frame);
    return text;
}

std::string format_candump_line(const LoggedFrame& logged) {
    std::string line = "(";
    line.reserve(longest_usual_line);
    append_seconds(line, logged.time);
    line.append(") ").append(logged.interface).append(" ");
    append_frame(line, logged.frame);
    return line;
}

}  // namespace canproof::host
