// SPDX-License-Identifier: Apache-2.0
// Each line marked `flagged` is an include that violates the layers.
#pragma once

#include "devices/cbx-ao412/firmware/voltage_output.hpp"  // flagged
#include "firmware/base/result.hpp"
#include "firmware/canopen/frame.hpp"       // flagged
#include "generated/cbx_ao412/objects.hpp"  // flagged
