// SPDX-License-Identifier: Apache-2.0
// The channel of an image in QEMU: standard input and output of the process that emulates it.
#pragma once

#include "target/bridge/channel.hpp"

namespace canproof::target {

class SemihostingChannel final : public Channel {
  public:
    SemihostingChannel();

  protected:
    bool read(std::uint8_t* to, std::size_t count) override;
    bool write(ByteView bytes) override;

  private:
    int in_;  ///< handle of the stream; negative when it could not be opened
    int out_;
};

/// Ends the process of QEMU with this exit status.
[[noreturn]] void end_image(std::uint32_t status);

}  // namespace canproof::target
