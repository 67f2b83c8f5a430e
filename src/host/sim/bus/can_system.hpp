// SPDX-License-Identifier: Apache-2.0
// The interface to the system calls of a raw CAN socket; a test can replace it.
#pragma once

#include <linux/can.h>

#include <cstdint>
#include <string>
#include <vector>

namespace canproof::host {

/// One frame from the kernel.
struct CanReception {
    can_frame frame{};
    std::uint64_t stamp_ns{0};  ///< CLOCK_REALTIME of its arrival; 0: unknown
    std::uint32_t dropped{0};   ///< frames that this socket has lost so far because there was no room
};

/// A new socket, or errno.
struct CanOpening {
    int descriptor{-1};
    int error{0};
    bool roomy{true};  ///< its receive buffer has the requested size
};

/// The result of setting a bit rate.
struct BitRateOutcome {
    bool done{false};
    std::string why;  ///< reason when not done
};

class CanSystem {
  public:
    virtual ~CanSystem() = default;

    /// Opens a non-blocking raw socket on the interface with receive time stamps, a drop counter and, if requested,
    /// error frames.
    virtual CanOpening open(const std::string& interface, bool error_frames) = 0;
    virtual void close(int descriptor) = 0;
    /// Sets the filters. Returns errno; 0 when done.
    virtual int set_filters(int descriptor, const std::vector<can_filter>& filters) = 0;
    virtual int send(int descriptor, const can_frame& frame) = 0;
    /// Appends the arrived frames of one system call and returns 0. Returns errno when there is none, or for an error.
    virtual int receive(int descriptor, std::vector<CanReception>& into) = 0;
    /// Returns the number of frames that the socket has lost so far, including those after the last frame read.
    virtual std::uint32_t dropped(int descriptor) = 0;
    /// Returns the number of the interface; 0 when it does not exist. A removed and recreated interface has another
    /// number.
    virtual unsigned interface_number(const std::string& interface) = 0;
    virtual bool is_up(const std::string& interface) = 0;
    /// Returns the bit rate in bit/s; 0 when the interface has none (vcan) or does not report it.
    virtual std::uint32_t bit_rate(const std::string& interface) = 0;
    /// Switches the interface off, sets the rate and switches the interface on again.
    virtual BitRateOutcome set_bit_rate(const std::string& interface, std::uint32_t bit_rate) = 0;
    /// Restarts a bus-off controller.
    virtual bool restart(const std::string& interface) = 0;
    /// Returns the time of CLOCK_REALTIME in ns.
    virtual std::uint64_t realtime_ns() = 0;
};

/// Requested receive buffer of each socket in bytes. The kernel counts about 800 bytes for a frame and doubles the
/// request. The result suffices for four seconds of frames without data at 1 Mbit/s.
inline constexpr int receive_room = 1 << 25;

}  // namespace canproof::host
