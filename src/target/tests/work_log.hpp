// SPDX-License-Identifier: Apache-2.0
// Counts the instructions of every power-on, frame and tick (device cycle), and records the worst case of each kind.
#pragma once

#include <string>

#include "firmware/canopen/frame.hpp"
#include "tests/support/bench_watch.hpp"

namespace canproof::target {

/// From now on, writes the work of each measurement to `path`, as a line `kind 1 instructions bits what where`; the 1
/// is the count.
void write_every_work(const std::string& path);
[[gnu::noinline]] void work_begins();
/// As work_begins(), for a frame that comes at the time of a deadline.
[[gnu::noinline]] void due_work_begins();
/// Stops counting. Call it before note_work() or note_frame(), so that their instructions are not counted.
void work_stops();
/// Records the work whose counting was stopped: `what` is a frame or "-", `where` the test or input to which it
/// belongs.
void note_work(test::Work work, const std::string& what, const std::string& where);
/// Records the work of a received frame, as note_work() does.
void note_frame(test::Work work, const Frame& frame, const std::string& what, const std::string& where);
/// Ends the record of the last noted work: the frames that follow are not due to it.
void skip_work();
/// Notes a frame that the device sent because of the last noted frame. If it wins arbitration against a frame with the
/// identifier of the noted one, its bits are added to that work.
void note_answer(const Frame& frame);
/// Writes lines `kind count instructions bits what where` to `path`. For power-ons, frames, frames at a deadline
/// (`due_frame`), ticks and commands (frames that reset the node or store its parameters) a line shows the work with
/// most instructions. For `share` it shows the frame with most instructions per bit, including the bits of its answers,
/// among those that can fill a bus. Returns false when the file cannot be written or nothing was counted.
bool write_work(const std::string& path);

}  // namespace canproof::target
