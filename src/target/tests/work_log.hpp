// The instructions of every power-on, frame and tick: how many there were, and which was the dearest.
#pragma once

#include <string>

#include "support/bench_watch.hpp"

namespace canproof::target {

/// From now on every piece of work is a line `kind instructions what where` in `path` as well.
void write_every_work(const std::string& path);
void work_begins();
/// Stops counting. Before anything else is done: what names the work is no part of it.
void work_stops();
/// What the work was that has stopped: `what` is a frame or "-", `where` the test or input that it belongs to.
void note_work(test::Work work, const std::string& what, const std::string& where);
/// Lines `kind count instructions what where` in `path`: of power-ons, frames, ticks and commands (frames that reset
/// the node or store its parameters) the one with most instructions, of `share` the frame with most for each of its
/// bits on the bus. Fails when nothing was counted.
bool write_work(const std::string& path);

}  // namespace canproof::target
