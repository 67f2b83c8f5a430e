// Whether the image in flash is the one that was built.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof::stm32f405 {

/// Whether the last four bytes of `image` are the CRC-32 of `vectors` and of what lies before them in `image`, least
/// significant byte first.
bool is_sound_image(ByteView vectors, ByteView image) noexcept;

}  // namespace canproof::stm32f405
