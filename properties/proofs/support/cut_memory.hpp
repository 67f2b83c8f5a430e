// SPDX-License-Identifier: Apache-2.0
// Non-volatile memory whose power fails after a number of written bytes.
#pragma once

#include "firmware/base/non_volatile_memory.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

/// A non-volatile memory of `count` bytes. After `left_` written bytes, the power fails: further writes have no effect.
template <std::size_t count>
class CutMemory final : public NonVolatileMemory {
  public:
    using Bytes = std::array<std::uint8_t, count>;
    static constexpr std::size_t no_cut = 1000U;

    explicit CutMemory(Bytes& bytes) : bytes_{bytes} {}
    std::size_t size() const override { return bytes_.size(); }
    bool read(const std::size_t at, MutableBytes to) const override {
        to.copy(0U, ByteView{bytes_}.part(at, to.size()));
        return true;
    }
    bool write(const std::size_t at, const ByteView bytes) override {
        for (std::size_t i = 0U; i < bytes.size(); ++i) {
            if (left_ != 0U) {
                bytes_[at + i] = bytes[i];
                --left_;
            }
        }
        return true;
    }
    bool commit() override { return true; }

    Bytes& bytes_;
    std::size_t left_{no_cut};
};

}  // namespace canproof::proofs
