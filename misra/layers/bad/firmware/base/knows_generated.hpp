// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "firmware/canopen/frame.hpp"  // flagged
#include "host/app/cli/commands.hpp"   // flagged
