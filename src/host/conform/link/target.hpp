// SPDX-License-Identifier: Apache-2.0
// The connection to the slave under test: a bus in virtual time, or a real bus.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host::conform {

/// A frame, and the time at which it was on the bus.
struct FrameRecord {
    Instant time{};
    Frame frame{};
    bool own{false};  ///< whether the tester sent the frame
};

/// Thrown when the user presses Ctrl-C.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error{"interrupted"} {}
};

/// The person or program that can switch the slave off and on.
enum class PowerSwitch {
    nobody,
    hand,    ///< the user, when the program asks; takes seconds
    program  ///< the program, without delay
};

class Target {
  public:
    virtual ~Target() = default;

    virtual Instant now() const = 0;
    virtual void send(const Frame& frame) = 0;
    /// Returns the number of frames that wait to be sent.
    virtual std::size_t waiting() const = 0;
    /// Lets time pass until `until`; returns earlier when a frame was on the bus. Throws Interrupted when the user
    /// presses Ctrl-C.
    virtual void advance(Instant until) = 0;
    /// Continues after an interruption, so that only the next Ctrl-C interrupts again.
    virtual void go_on() {}

    virtual PowerSwitch power_switch() const { return PowerSwitch::nobody; }
    /// Switches the slave off or on and returns when that is done. Frames are received meanwhile. Throws Interrupted.
    virtual void power(bool) {}
    /// Returns whether the bus switches to each new bit rate that LSS sets in the slave.
    virtual bool follows_bit_rate() const { return false; }
    /// Returns whether the bus carries remote frames.
    bool has_remote_frames() const { return remote_frames_; }
    /// Declares that the bus carries no remote frames, so that all further cases with remote frames are skipped.
    void leave_out_remote_frames() { remote_frames_ = false; }
    /// Returns the bit rate in bit/s; 0: unknown.
    virtual std::uint32_t bit_rate() const = 0;
    /// Returns the name of the target for the report: `virtual time`, `socketcan:can0`.
    virtual const std::string& name() const = 0;
    /// Returns whether every run gives the same frames at the same times. A failed case is then not repeated.
    virtual bool is_repeatable() const { return false; }
    virtual BusReport report() const = 0;

    /// Sets the listener for every frame on the bus in order of time, including the tester's own frames.
    void listen(std::function<void(const FrameRecord&)> listener) { listener_ = std::move(listener); }

  protected:
    void tell(const FrameRecord& record) const {
        if (listener_) {
            listener_(record);
        }
    }

  private:
    bool remote_frames_{true};
    std::function<void(const FrameRecord&)> listener_;
};

}  // namespace canproof::host::conform
