// candump's log format: `(seconds.micros) iface ID#DATA`, `ID#R` for a remote frame.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

struct LoggedFrame {
    Instant time{};
    std::string interface;
    Frame frame{};
    bool transmitted{false};  ///< T behind the frame: sent by whoever wrote the log
};

/// One line of a log. Throws InputError, which names `where` ("file:line").
LoggedFrame parse_candump_line(const std::string& line, const std::string& where);
/// All lines, in ascending time; empty lines are passed over. `name` is for messages.
std::vector<LoggedFrame> read_candump_log(std::istream& in, const std::string& name);
std::string format_candump_line(const LoggedFrame& logged);
/// `703#00`
std::string format_frame(const Frame& frame);
/// `703#00` to a frame; throws InputError.
Frame parse_frame(const std::string& text, const std::string& where);
/// `12.345678` (seconds) to a time; throws InputError.
Instant parse_seconds(const std::string& text, const std::string& where);
std::string format_seconds(Instant time);

}  // namespace canproof::host
