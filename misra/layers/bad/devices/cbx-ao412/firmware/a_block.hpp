// SPDX-License-Identifier: Apache-2.0
// A file in a device's folder is a block of the device if its name does not begin with the device's name.
#pragma once

#include "devices/ax130751/firmware/relay.hpp"  // flagged
#include "devices/cbx-ao412/firmware/another_block.hpp"
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"  // flagged
#include "firmware/base/result.hpp"
#include "firmware/blocks/bounds.hpp"
#include "firmware/canopen/frame.hpp"        // flagged
#include "generated/ax130751/constants.hpp"  // flagged
#include "generated/canopen/vocabulary.hpp"  // flagged
#include "generated/cbx_ao412/constants.hpp"
#include "generated/cbx_ao412/objects.hpp"  // flagged
#include "host/base/reading.hpp"            // flagged
