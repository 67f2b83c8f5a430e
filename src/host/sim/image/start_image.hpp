// SPDX-License-Identifier: Apache-2.0
// Starts a device's image on the emulated microcontroller.
#pragma once

#include <memory>
#include <string>

#include "host/sim/image/image_link.hpp"

namespace canproof::host {

/// Starts an STM32F405 in QEMU with that image; the process ends with the link. Throws InputError when there is no QEMU
/// or no such file. Any other defect of the file shows when the greeting does not come.
std::unique_ptr<ImageLink> start_image(const std::string& path);

}  // namespace canproof::host
