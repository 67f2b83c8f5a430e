// SPDX-License-Identifier: Apache-2.0
// The file of `--log`: every frame of a bus, for other programs and for replay.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "host/sim/bus/candump.hpp"

namespace canproof::host {

enum class LogFormat : std::uint8_t {
    candump,  ///< in the format of `candump -L`
    marked,   ///< in the format of `candump -L -x`: T after frames of these devices, R after those of others
    pcap,     ///< for Wireshark and SavvyCAN: link type 227 (SocketCAN)
    pcapng,   ///< for Wireshark: as pcap, and with the direction of each frame; SavvyCAN ignores its link type
};

/// Returns the format for a file's name and the option for marks.
LogFormat log_format(const std::string& path, bool marks);

class FrameLog {
  public:
    /// `out` may be nullptr: nothing is written.
    FrameLog(std::ostream* out, LogFormat format) : out_{out}, format_{format} {}

    bool is_wanted() const { return out_ != nullptr; }
    /// Writes the header before the first frame.
    void begin(const std::string& interface);
    /// Writes a frame; `own` means that one of these devices has sent it.
    void write(const LoggedFrame& frame, bool own);

  private:
    std::ostream* out_;
    LogFormat format_;
};

}  // namespace canproof::host
