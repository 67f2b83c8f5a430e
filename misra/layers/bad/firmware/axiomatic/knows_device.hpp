#pragma once

#include "devices/ax130751/firmware/ax130751.hpp"  // flagged
#include "firmware/base/result.hpp"
#include "firmware/canopen/node.hpp"
#include "host/base/reading.hpp"  // flagged
