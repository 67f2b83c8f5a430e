// A deliberate fault of a slave: what is wrong, how that is made, and a talk that shows it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "host/register/register.hpp"

namespace canproof::test::zoo {

class WrongSlave;

using FrameHook = std::function<void(WrongSlave&, const Frame&)>;

/// Where a fault gets hold of a correct slave. A hook that is empty changes nothing. A copy has a state of its own:
/// what a hook remembers stands in WrongSlave::notes.
struct Distortion {
    std::function<void(host::Part&)> part;  ///< alters the dictionary before the slave is made
    FrameHook hear;                         ///< in place of WrongSlave::pass: a frame of the bus
    FrameHook say;                          ///< in place of WrongSlave::say: a frame of the correct slave
};

/// One fault of the zoo.
struct Fault {
    std::string id;       ///< kebab-case, unique
    std::string service;  ///< the group of the cases that must name it: "sdo", "lss"
    std::string what;     ///< what the slave does wrong; begins with a verb
    /// Frames to the slave and waits in ms, `605#4000100000000000 +100`. The node-ID is 5.
    std::string talk;
    std::string
        right;  ///< frames of that talk that the correct slave alone sends; after a wait with its time: `100:705#7F`
    std::string wrong;  ///< frames that the wrong slave alone sends
    Distortion distortion;
};

using Faults = std::vector<Fault>;

}  // namespace canproof::test::zoo
