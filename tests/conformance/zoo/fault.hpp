// SPDX-License-Identifier: Apache-2.0
// A deliberate fault of a slave: its description, its implementation, and an exchange that shows it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "host/register/register.hpp"

namespace canproof::test::zoo {

class WrongSlave;

using FrameHook = std::function<void(WrongSlave&, const Frame&)>;

/// The hooks with which a fault changes a correct slave. An empty hook changes nothing. A hook has
/// no state of its own; its state is in WrongSlave::notes.
struct Distortion {
    std::function<void(host::Part&)> part;  ///< alters the dictionary before the slave is made
    FrameHook hear;                         ///< replaces WrongSlave::pass, which gets each frame of the bus
    FrameHook say;                          ///< replaces WrongSlave::say, which gets each frame of the correct slave
};

/// One fault of a wrong slave.
struct Fault {
    std::string id;       ///< kebab-case, unique
    std::string service;  ///< group of the conformance cases that must notice the fault: "sdo", …
    std::string what;     ///< the fault of the slave; begins with a verb
    /// Frames to the slave and waits in ms, `605#4000100000000000 +100`. The node-ID is 5.
    std::string talk;
    /// Frames that only the correct slave sends in that exchange; after a wait, each with its time: `100:705#7F`.
    std::string right;
    std::string wrong;  ///< frames that only the wrong slave sends
    Distortion distortion;
};

using Faults = std::vector<Fault>;

}  // namespace canproof::test::zoo
