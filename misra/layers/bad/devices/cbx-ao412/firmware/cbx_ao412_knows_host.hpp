// SPDX-License-Identifier: Apache-2.0
// A file in a device's folder is part of the device itself if its name begins with the device's name.
#pragma once

#include "devices/ax130751/firmware/relay.hpp"  // flagged
#include "devices/catalogue.hpp"                // flagged
#include "devices/cbx-ao412/firmware/a_block.hpp"
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "devices/cbx-ao412/simulation/model.hpp"  // flagged
#include "firmware/blocks/bounds.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/ax130751/constants.hpp"  // flagged
#include "generated/canopen/vocabulary.hpp"
#include "generated/cbx_ao412/objects.hpp"
#include "host/sim/bus/bus.hpp"  // flagged
