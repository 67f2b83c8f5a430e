// SPDX-License-Identifier: Apache-2.0
// Starts a device's image on the emulated microcontroller.
#pragma once

#include <memory>
#include <string>

#include "host/sim/image/image_link.hpp"

namespace canproof::host {

/// Starts the microcontroller of this image in QEMU: an STM32F405, or a Zynq UltraScale+ with both CAN controllers on
/// one bus. The process ends when the link is destroyed or this program ends. Throws InputError when QEMU or the file
/// does not exist, or the file is no program for ARM. If the file has any other defect, the image sends no greeting.
std::unique_ptr<ImageLink> start_image(const std::string& path);

}  // namespace canproof::host
