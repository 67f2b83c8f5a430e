// candump's log format: `(seconds.micros) iface ID#DATA`, `ID#R` for a remote frame.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/reading.hpp"

namespace canproof::host {

/// What a log says of who has sent a frame: T for whoever wrote the log, R for others.
enum class LogMark : std::uint8_t { none, transmitted, received };

struct LoggedFrame {
    Instant time{};
    std::string interface;
    Frame frame{};
    LogMark mark{LogMark::none};
    bool error{false};  ///< an error frame, as candump logs it: no frame that a node receives
    bool coded{false};  ///< with a length code of 9 to 15 behind the data: eight bytes all the same
};

/// One line of a log; `candump -L -x` marks frames with T and R. Throws InputError, which names `where` ("file:line").
LoggedFrame parse_candump_line(const std::string& line, const std::string& where);
/// What stands in a log beside frames as a node receives them.
struct LogCounts {
    std::uint64_t error_frames{0};
    std::uint64_t coded_lengths{0};
};

/// The frames of a log one after another, in ascending time. Empty lines and error frames are passed over.
class CandumpReader {
  public:
    /// `name` is for messages.
    CandumpReader(std::istream& in, std::string name) : lines_{in, std::move(name)} {}

    /// False at the end. Throws InputError.
    bool next(LoggedFrame& frame);
    const LogCounts& counts() const { return counts_; }

  private:
    LineReader lines_;
    Instant last_{};
    LogCounts counts_;
};

/// All frames of a log.
std::vector<LoggedFrame> read_candump_log(std::istream& in, const std::string& name);
std::string format_candump_line(const LoggedFrame& logged);
/// `703#00`
std::string format_frame(const Frame& frame);
/// `703#00` to a frame, also with a length code behind eight bytes (`303#0102030405060708_F`); throws InputError.
Frame parse_frame(const std::string& text, const std::string& where);

}  // namespace canproof::host
