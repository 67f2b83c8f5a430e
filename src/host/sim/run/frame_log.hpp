// SPDX-License-Identifier: Apache-2.0
// Writes the file of `--log`: every frame of a bus, for other programs and for replay.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "host/sim/bus/candump.hpp"

namespace canproof::host {

enum class LogFormat : std::uint8_t {
    candump,  ///< the format of `candump -L`
    marked,   ///< the format of `candump -L -x`: T after frames of the run's own devices, R after all other frames
    pcap,     ///< for Wireshark and SavvyCAN, with link type 227 (SocketCAN)
    /// for Wireshark: like pcap, with the direction of each frame; SavvyCAN does not read link type 227 from pcapng
    pcapng,
};

/// Returns the format for the name of a file. `marks`: the user has requested T or R at the end of each line of a
/// candump log.
LogFormat log_format(const std::string& path, bool marks);

class FrameLog {
  public:
    /// Writes to `out`; writes nothing if `out` is nullptr.
    FrameLog(std::ostream* out, LogFormat format) : out_{out}, format_{format} {}

    bool is_wanted() const { return out_ != nullptr; }
    /// Writes the header of the file, if the format has one. Must be called before the first frame.
    void begin(const std::string& interface);
    /// Writes a frame. `own` is true when a device of this run has sent it.
    void write(const LoggedFrame& frame, bool own);

  private:
    std::ostream* out_;
    LogFormat format_;
};

}  // namespace canproof::host
