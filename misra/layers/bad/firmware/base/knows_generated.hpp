#pragma once

#include "firmware/canopen/frame.hpp"  // flagged
#include "host/app/cli/commands.hpp"   // flagged
