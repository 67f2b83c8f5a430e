// SPDX-License-Identifier: Apache-2.0
// A deliberate fault of a slave: its description, its implementation, and an exchange of frames in which the slave with
// the fault behaves differently.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "host/register/register.hpp"

namespace canproof::test::zoo {

class WrongSlave;

using FrameHook = std::function<void(WrongSlave&, const Frame&)>;

/// The hooks (functions) with which a fault changes a correct slave. An empty hook changes nothing. Hooks store their
/// state in WrongSlave::notes.
struct Distortion {
    std::function<void(host::Part&)> part;  ///< changes the description of the slave before the slave is made
    FrameHook hear;                         ///< gets each frame on the bus instead of WrongSlave::pass
    FrameHook say;                          ///< gets each frame of the correct slave instead of WrongSlave::say
};

/// One deliberate fault of a slave.
struct Fault {
    std::string id;       ///< kebab-case, unique
    std::string service;  ///< group of the conformance cases that must notice the fault: "sdo", …
    std::string what;     ///< the wrong behaviour of the slave; begins with a verb
    /// Frames to the slave (node 5) and waits in ms, for example `605#4000100000000000 +100`.
    std::string talk;
    /// Frames that only the correct slave sends in this exchange. After a wait, each has its time: `100:705#7F`.
    std::string right;
    std::string wrong;  ///< frames that only the slave with the fault sends
    Distortion distortion;
};

using Faults = std::vector<Fault>;

}  // namespace canproof::test::zoo
