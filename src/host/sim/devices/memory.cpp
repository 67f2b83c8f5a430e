// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/memory.hpp"

namespace canproof::host {

bool Memory::read(std::size_t at, MutableBytes to) const {
    if (at > bytes_.size() || to.size() > bytes_.size() - at) {
        return false;
    }
    for (std::size_t i = 0; i < to.size(); ++i) {
        to.set(i, bytes_[at + i]);
    }
    return true;
}

bool Memory::write(std::size_t at, ByteView bytes) {
    if (at > bytes_.size() || bytes.size() > bytes_.size() - at) {
        return false;
    }
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes_left_ == 0) {
            return false;
        }
        --bytes_left_;
        ++written_;
        bytes_[at + i] = bytes[i];
    }
    return true;
}

bool Memory::commit() {
    if (!keeper_) {
        return true;
    }
    const bool done = keeper_(bytes_);
    (done ? kept_ : bytes_) = done ? bytes_ : kept_;
    return done;
}

}  // namespace canproof::host
