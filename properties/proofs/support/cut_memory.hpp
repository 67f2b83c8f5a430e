// SPDX-License-Identifier: Apache-2.0
// Non-volatile memory whose power fails after a number of written bytes.
#pragma once

#include "firmware/base/non_volatile_memory.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

/// A view of `count` bytes as non-volatile memory. Writes beyond the first `left_` bytes have no effect, as after a
/// power cut.
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
