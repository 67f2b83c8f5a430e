// SPDX-License-Identifier: Apache-2.0
// The interface to the system calls of a raw CAN socket; a test can replace it.
#pragma once

#include <linux/can.h>

#include <cstdint>
#include <string>
#include <vector>

#include "host/base/descriptor.hpp"

namespace canproof::host {

/// A frame that the kernel has received.
struct CanReception {
    can_frame frame{};
    std::uint64_t stamp_ns{0};  ///< time of its arrival (CLOCK_REALTIME) in ns; 0: unknown
    std::uint32_t dropped{0};   ///< number of frames that this socket has lost so far because it had no room
};

/// The result of opening a socket: the socket, or errno.
struct CanOpening {
    Descriptor socket;
    int error{0};
    bool roomy{true};  ///< whether its receive buffer has the requested size
};

/// The result of setting a bit rate.
struct BitRateOutcome {
    bool done{false};
    std::string why;  ///< reason when the bit rate was not set
};

class CanSystem {
  public:
    virtual ~CanSystem() = default;

    /// Opens a non-blocking raw socket on the interface, with time stamps of reception and a counter of lost frames. If
    /// `error_frames` is true, the socket also receives error frames.
    virtual CanOpening open(const std::string& interface, bool error_frames) = 0;
    /// Sets the filters of a socket. Returns 0, or errno when it fails.
    virtual int set_filters(int descriptor, const std::vector<can_filter>& filters) = 0;
    virtual int send(int descriptor, const can_frame& frame) = 0;
    /// Appends the frames that one system call reads, and returns 0. Returns errno when there is no frame, or on an
    /// error.
    virtual int receive(int descriptor, std::vector<CanReception>& into) = 0;
    /// Returns the number of frames that the socket has lost so far. The number includes frames lost after the last
    /// frame that was read.
    virtual std::uint32_t dropped(int descriptor) = 0;
    /// Returns the number of the interface; 0 when it does not exist. An interface that was removed and made again has
    /// another number.
    virtual unsigned interface_number(const std::string& interface) = 0;
    virtual bool is_up(const std::string& interface) = 0;
    /// Returns the bit rate of the interface in bit/s; 0 when it has none (vcan) or does not report it.
    virtual std::uint32_t bit_rate(const std::string& interface) = 0;
    /// Switches the interface off, sets the bit rate in bit/s, and switches the interface on again. Does nothing when
    /// the interface already has this bit rate, and fails when the interface has no bit rate.
    virtual BitRateOutcome set_bit_rate(const std::string& interface, std::uint32_t bit_rate) = 0;
    /// Restarts the bus-off controller of the interface. Returns whether this was possible.
    virtual bool restart(const std::string& interface) = 0;
    /// Returns the time of CLOCK_REALTIME in ns.
    virtual std::uint64_t realtime_ns() = 0;
};

/// Requested receive buffer of each socket in bytes. The kernel doubles the request and counts about 800 bytes for a
/// frame. The buffer suffices for about four seconds of frames without data at 1 Mbit/s.
inline constexpr int receive_room = 1 << 25;

}  // namespace canproof::host
