// The instructions of every power-on, frame and tick: how many there were, and which was the dearest.
#pragma once

#include <string>

#include "firmware/canopen/frame.hpp"
#include "tests/support/bench_watch.hpp"

namespace canproof::target {

/// From now on every piece of work is a line `kind 1 instructions bits what where` in `path` as well.
void write_every_work(const std::string& path);
void work_begins();
/// Stops counting. Before anything else is done: what names the work is no part of it.
void work_stops();
/// What the work was that has stopped: `what` is a frame or "-", `where` the test or input that it belongs to.
void note_work(test::Work work, const std::string& what, const std::string& where);
/// The same for a received frame.
void note_frame(const Frame& frame, const std::string& what, const std::string& where);
/// The device has sent a frame because of the one noted last. Where its identifier gives it the bus before the next
/// one like that, both take their bits of a full bus.
void note_answer(const Frame& frame);
/// Lines `kind count instructions bits what where` in `path`: of power-ons, frames, ticks and commands (frames that
/// reset the node or store its parameters) the one with most instructions, of `share` the frame with most for each of
/// the bits that it and its answers take on the bus. Fails when nothing was counted.
bool write_work(const std::string& path);

}  // namespace canproof::target
