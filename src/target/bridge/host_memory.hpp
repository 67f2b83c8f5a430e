// SPDX-License-Identifier: Apache-2.0
// The parameter memory of an image whose board is simulated by a program on the host. That program keeps the bytes and
// reports whether each access succeeded.
#pragma once

#include "firmware/base/non_volatile_memory.hpp"
#include "target/bridge/channel.hpp"

namespace canproof::target {

class HostMemory final : public NonVolatileMemory {
  public:
    HostMemory(Channel& channel, const std::size_t size) : channel_{channel}, size_{size} {}

    std::size_t size() const override { return size_; }
    bool read(std::size_t at, MutableBytes to) const override;
    bool write(std::size_t at, ByteView bytes) override;
    bool commit() override;

  private:
    /// Sends a request and waits for the answer, which replaces `message`. Returns whether the access succeeded.
    bool ask(bridge::Message& message) const;

    Channel& channel_;
    std::size_t size_;
};

}  // namespace canproof::target
