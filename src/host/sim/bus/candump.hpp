// SPDX-License-Identifier: Apache-2.0
// The log format of candump: `(seconds.micros) interface ID#DATA`, or `ID#R` for a remote frame.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/reading.hpp"

namespace canproof::host {

/// The letter at the end of a log line (`candump -x`): T for a frame of the program that wrote the log, R for a frame
/// of others.
enum class LogMark : std::uint8_t { none, transmitted, received };

struct LoggedFrame {
    Instant time{};
    std::string interface;
    Frame frame{};
    LogMark mark{LogMark::none};
    bool error{false};  ///< whether it is an error frame in candump's form, which no node receives
    /// whether a length code of 9 to 15 follows the data; the length of the data is still eight bytes
    bool coded{false};
};

/// Parses one line of a log. The line may end with the letter T or R of `candump -L -x`. Throws InputError with `where`
/// ("file:line") for any other line.
LoggedFrame parse_candump_line(const std::string& line, const std::string& where);
/// Counts of unusual lines in a log.
struct LogCounts {
    std::uint64_t error_frames{0};
    std::uint64_t coded_lengths{0};
};

/// Reads the frames of a log one after another. Their times must be ascending. Skips empty lines and error frames.
class CandumpReader {
  public:
    /// Prepares to read `in`. `name` is the name of the log in messages.
    CandumpReader(std::istream& in, std::string name) : lines_{in, std::move(name)} {}

    /// Reads the next frame. Returns false at the end of the log. Throws InputError for an invalid line.
    bool next(LoggedFrame& frame);
    const LogCounts& counts() const { return counts_; }

  private:
    LineReader lines_;
    Instant last_{};
    LogCounts counts_;
};

/// Reads all frames of a log. Throws InputError for an invalid line.
std::vector<LoggedFrame> read_candump_log(std::istream& in, const std::string& name);
std::string format_candump_line(const LoggedFrame& logged);
/// Returns a frame as text: `703#00`.
std::string format_frame(const Frame& frame);
/// Parses a frame such as `703#00`. A length code may follow eight bytes (`303#0102030405060708_F`). Throws InputError
/// with `where` for any other text.
Frame parse_frame(const std::string& text, const std::string& where);

}  // namespace canproof::host
