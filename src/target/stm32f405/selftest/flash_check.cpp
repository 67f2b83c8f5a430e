// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/flash_check.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

static_assert(implements<req::CO_SELF_002>);
bool FlashCheck::step() noexcept {
    const bool in_vectors = next_ < vectors_.size();
    const ByteView bytes = in_vectors ? vectors_.part(next_, slice) : image_.part(next_ - vectors_.size(), slice);
    crc_.add(bytes);
    next_ += bytes.size();
    if (next_ < (vectors_.size() + image_.size())) {
        return true;
    }
    const bool is_sound = crc_.value() == Crc32::residue;
    crc_ = Crc32{};
    next_ = 0U;
    ++passes_;
    return is_sound;
}

}  // namespace canproof::stm32f405
