#pragma once

#include "firmware/canopen/frame.hpp"  // flagged
#include "host/cli/command.hpp"  // flagged
