#pragma once

#include "firmware/canopen/node.hpp"
#include "host/sim/bus/bus.hpp"  // flagged
