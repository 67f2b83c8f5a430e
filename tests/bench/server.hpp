// SPDX-License-Identifier: Apache-2.0
// The interface of a server that answers the frames of a transaction. tests/bench/count counts the instructions in
// receive(), pump() and change(). These three functions cover everything from the received frame until the frames to
// send are taken from the queue.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/canopen/frame.hpp"

namespace canproof::bench {

class Server {
  public:
    Server() = default;
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    virtual ~Server() = default;

    /// Gives one frame to the server; its answers are taken from the queue and counted.
    virtual void receive(const Frame& frame) = 0;
    /// Continues a block upload: puts as many segments into the transmit queue as it has space for.
    virtual void pump() = 0;
    /// Sets an entry to a new value, as the application of a device does. Returns how many frames the server then
    /// sends.
    virtual std::size_t change(std::uint16_t index, std::uint8_t subindex) = 0;

    /// These two functions prepare a transaction: receive_words() maps 5F02h:1…4 into the RPDO with this identifier.
    /// send_words() maps them into the TPDO with this identifier, which is sent when they change.
    virtual void receive_words(std::uint32_t identifier) = 0;
    virtual void send_words(std::uint32_t identifier) = 0;

    /// Returns the last frame that was taken from the queue.
    const Frame& last() const { return last_; }

  protected:
    Frame last_{};
};

}  // namespace canproof::bench
