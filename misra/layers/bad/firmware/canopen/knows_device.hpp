// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "firmware/base/result.hpp"
#include "devices/ax130751/firmware/relay.hpp"  // flagged
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"  // flagged
#include "generated/canopen/vocabulary.hpp"
