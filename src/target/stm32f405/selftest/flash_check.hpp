// SPDX-License-Identifier: Apache-2.0
// A continuous check of the image in flash: computes its CRC-32 in slices and compares the result with the CRC at its
// end (the seal).
#pragma once

#include "firmware/base/crc32.hpp"

namespace canproof::stm32f405 {

class FlashCheck {
  public:
    /// Number of bytes in a slice, which one step adds to the CRC.
    static constexpr std::size_t slice = 16U;

    /// The last four bytes of `image` are the stored CRC (the seal); see is_sound_image().
    FlashCheck(const ByteView vectors, const ByteView image) noexcept : vectors_{vectors}, image_{image} {}

    /// Adds the next slice. Returns false when it was the last slice and the CRC differs from the stored one (the
    /// seal).
    bool step() noexcept;
    /// Returns the number of completed checks of the whole image.
    std::uint32_t passes() const noexcept { return passes_; }

  private:
    ByteView vectors_;
    ByteView image_;
    Crc32 crc_{};
    std::size_t next_{0U};  ///< position of the next byte in the vectors and the image behind them
    std::uint32_t passes_{0U};
};

}  // namespace canproof::stm32f405
