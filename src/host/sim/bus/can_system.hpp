// The system calls behind a raw CAN socket, so that a test can make up what they answer.
#pragma once

#include <linux/can.h>

#include <cstdint>
#include <string>
#include <vector>

namespace canproof::host {

/// One frame as the kernel hands it out.
struct CanReception {
    can_frame frame{};
    std::uint64_t stamp_ns{0};  ///< CLOCK_REALTIME when it arrived; 0: not known
    std::uint32_t dropped{0};   ///< frames that this socket has lost so far for want of room
};

/// A new socket, or errno.
struct CanOpening {
    int descriptor{-1};
    int error{0};
    bool roomy{true};  ///< its receive buffer is as large as was asked for
};

/// What came of the wish to set a bit rate.
struct BitRateOutcome {
    bool done{false};
    std::string why;  ///< when not done
};

class CanSystem {
  public:
    virtual ~CanSystem() = default;

    /// A non-blocking raw socket bound to the interface, with receive time stamps, a drop counter and, if wanted, error
    /// frames.
    virtual CanOpening open(const std::string& interface, bool error_frames) = 0;
    virtual void close(int descriptor) = 0;
    /// errno, 0 when done.
    virtual int set_filters(int descriptor, const std::vector<can_filter>& filters) = 0;
    virtual int send(int descriptor, const can_frame& frame) = 0;
    /// Appends frames that are there, as many as come in one call: 0. None there or another trouble: errno.
    virtual int receive(int descriptor, std::vector<CanReception>& into) = 0;
    /// Frames that the socket has lost so far, those behind the last one read included.
    virtual std::uint32_t dropped(int descriptor) = 0;
    /// Its number; 0 when there is no such interface. It changes when an interface is removed and made again.
    virtual unsigned interface_number(const std::string& interface) = 0;
    virtual bool is_up(const std::string& interface) = 0;
    /// bit/s; 0 where the interface has none (vcan) or does not tell.
    virtual std::uint32_t bit_rate(const std::string& interface) = 0;
    /// Takes the interface down, sets the rate and takes it up again.
    virtual BitRateOutcome set_bit_rate(const std::string& interface, std::uint32_t bit_rate) = 0;
    /// Restarts a controller that is bus-off.
    virtual bool restart(const std::string& interface) = 0;
    /// CLOCK_REALTIME in ns.
    virtual std::uint64_t realtime_ns() = 0;
};

/// Bytes of room asked for on each socket; the kernel counts some 800 for a frame and gives twice what is asked.
/// Four seconds of frames without data at 1 Mbit/s.
inline constexpr int receive_room = 1 << 25;

}  // namespace canproof::host
