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
/// Starts counting the instructions of a work, unless it is a frame that comes too late: that has no limit.
void work_begins(test::Work work);
/// Stops counting. Call it before note_work() or note_frame(), so that their instructions are not counted.
void work_stops();
/// Records the work whose counting was stopped: `what` is a frame or "-", `where` the test or input to which it
/// belongs.
void note_work(test::Work work, const std::string& what, const std::string& where);
/// Records the work of a received frame, as note_work() does, but not that of a frame that comes too late.
void note_frame(test::Work work, const Frame& frame, const std::string& what, const std::string& where);
/// Notes a frame that the device sent because of the last noted frame. If it wins arbitration against a frame with the
/// identifier of the noted one, its bits are added to that work.
void note_answer(const Frame& frame);
/// Writes lines `kind count instructions bits what where` to `path`. For each kind but `share`, a line shows the work
/// with most instructions. The kinds are power-on, frame, tick, and command (a frame that resets the node or stores its
/// parameters). Further kinds are a tick in the first millisecond after a power-on (`first_tick`), a tick after
/// more frames than a bus carries (`crowded_tick`), and frames and commands at the time of a deadline (`due_frame`,
/// `due_command`). For `share` the line shows the frame with most
/// instructions per bit, including the bits of its answers, among those that can fill a bus. Returns false when the
/// file cannot be written or nothing was counted.
bool write_work(const std::string& path);

}  // namespace canproof::target
