// The file that --log names: every frame of a bus, for other programs and for replay.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "host/sim/bus/candump.hpp"

namespace canproof::host {

enum class LogFormat : std::uint8_t {
    candump,  ///< as `candump -L` writes it
    marked,   ///< as `candump -L -x`: T behind the frames of our devices, R behind the others'
    pcapng,   ///< for Wireshark and SavvyCAN: link type 227 (SocketCAN), a direction with each frame
};

/// What a file's name asks for.
LogFormat log_format(const std::string& path, bool marks);

class FrameLog {
  public:
    /// `out` may be nullptr: nothing is written.
    FrameLog(std::ostream* out, LogFormat format) : out_{out}, format_{format} {}

    bool is_wanted() const { return out_ != nullptr; }
    /// What stands before the first frame.
    void begin(const std::string& interface);
    /// `own`: one of our devices has sent it.
    void write(const LoggedFrame& frame, bool own);

  private:
    std::ostream* out_;
    LogFormat format_;
};

}  // namespace canproof::host
