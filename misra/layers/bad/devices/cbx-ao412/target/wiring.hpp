// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/ax060805.hpp"  // flagged
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "host/base/file.hpp"      // flagged
#include "target/image/image.hpp"  // flagged
#include "target/stm32f405/chip.hpp"
