#pragma once

#include "firmware/canopen/node.hpp"
#include "host/bus/bus.hpp"  // flagged
