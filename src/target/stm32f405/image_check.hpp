// SPDX-License-Identifier: Apache-2.0
// Checks that the image in flash is the one that was built.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof::stm32f405 {

/// Returns whether the last four bytes of `image`, least significant byte first, are the CRC-32 of `vectors` followed
/// by the rest of `image`. An image without any other byte is not sound.
bool is_sound_image(ByteView vectors, ByteView image) noexcept;

}  // namespace canproof::stm32f405
