#pragma once

#include "firmware/base/result.hpp"
#include "firmware/blocks/relay.hpp"  // flagged
#include "firmware/devices/cbx_ao412.hpp"  // flagged
#include "generated/canopen/vocabulary.hpp"
