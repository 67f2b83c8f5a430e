// SPDX-License-Identifier: Apache-2.0
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"  // flagged
#include "firmware/canopen/frame.hpp"
#include "host/base/file.hpp"  // flagged
#include "target/board.hpp"    // flagged
#include "target/stm32f405/register.hpp"
