// SPDX-License-Identifier: Apache-2.0
// Lets a test program observe its test fixtures (benches): the frames on the bus, and the processing in each step (a
// received frame, a deadline, a power-on). Without an observer, each step costs one call of an empty function.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::test {

/// A kind of step of a device. A frame comes when nothing is due, at the time of a deadline (due_frame), or later than
/// a deadline (late_frame), which a caller that keeps the deadlines never does. A lone frame is one that comes when
/// nothing is due, but that cannot come again and again: its work needs frames that came before. A first tick is a tick
/// in the first millisecond after a power-on. A crowded tick comes after more frames than a bus of 1 Mbit/s carries
/// since the deadline before and the driver keeps (BusTime).
enum class Work { power_on, frame, lone_frame, due_frame, late_frame, tick, first_tick, crowded_tick };

/// Returns what a frame at `now` is when the device's next deadline is `deadline`; a deadline of zero means "at once".
inline Work frame_work(Instant deadline, Instant now) {
    if (deadline > now) {
        return Work::frame;
    }
    return (deadline == Instant{} || deadline == now) ? Work::due_frame : Work::late_frame;
}

struct BenchWatch {
    void (*heard)(Instant now, const Frame& frame){[](Instant, const Frame&) {}};
    void (*said)(Instant now, const Frame& frame){[](Instant, const Frame&) {}};
    void (*begins)(Work work){[](Work) {}};
    /// Reports the end of a step. If the step was the processing of a received frame, `what` is this frame as in a
    /// candump log.
    void (*ends)(Work work, const char* what){[](Work, const char*) {}};
};

inline BenchWatch bench_watch;

}  // namespace canproof::test
