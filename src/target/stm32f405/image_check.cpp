// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/image_check.hpp"

#include "firmware/base/crc32.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

static_assert(implements<req::CO_IMAGE_001>);
bool is_sound_image(const ByteView vectors, const ByteView image) noexcept {
    Crc32 crc{};
    crc.add(vectors);
    crc.add(image);
    return (image.size() > sizeof(std::uint32_t)) && (crc.value() == Crc32::residue);
}

}  // namespace canproof::stm32f405
