// Where the slave under test is: a bus in virtual time, or a real one.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host::conform {

/// A frame on the bus, with the time that the bus gives it.
struct FrameRecord {
    Instant time{};
    Frame frame{};
    bool own{false};  ///< sent by the tester
};

/// The user wants an end: Ctrl-C.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error{"interrupted"} {}
};

/// Who switches the slave off and on.
enum class PowerSwitch {
    nobody,
    hand,    ///< the user, when told to; takes seconds
    program  ///< at once
};

class Target {
  public:
    virtual ~Target() = default;

    virtual Instant now() const = 0;
    virtual void send(const Frame& frame) = 0;
    /// Frames that wait to be sent.
    virtual std::size_t waiting() const = 0;
    /// Lets time pass up to `until`; less when a frame has gone over the bus. Throws Interrupted.
    virtual void advance(Instant until) = 0;
    /// From now on an interruption is awaited again.
    virtual void go_on() {}

    virtual PowerSwitch power_switch() const { return PowerSwitch::nobody; }
    /// Returns when the slave is off, or on; frames come meanwhile. Throws Interrupted.
    virtual void power(bool) {}
    /// Whether the bus takes the bit rate that the slave takes.
    virtual bool follows_bit_rate() const { return false; }
    /// Whether the bus carries remote frames.
    virtual bool has_remote_frames() const { return true; }
    /// bit/s; 0: not known
    virtual std::uint32_t bit_rate() const = 0;
    /// For the report: `virtual time`, `socketcan:can0`.
    virtual const std::string& name() const = 0;
    /// Whether a failure would only repeat itself: time and frames are the same each time.
    virtual bool is_repeatable() const { return false; }
    virtual BusReport report() const = 0;

    /// Is told every frame, own ones as well, in order of time.
    void listen(std::function<void(const FrameRecord&)> listener) { listener_ = std::move(listener); }

  protected:
    void tell(const FrameRecord& record) const {
        if (listener_) {
            listener_(record);
        }
    }

  private:
    std::function<void(const FrameRecord&)> listener_;
};

}  // namespace canproof::host::conform
