// What a transaction is tried on: something that answers frames. What is counted goes through receive(), pump() and
// change(): from the frame or event that the server gets to the frames that are taken from its queue.
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
    /// Lets a block upload send what is due.
    virtual void pump() = 0;
    /// The device gave an entry a new value. How many frames that caused.
    virtual std::size_t change(std::uint16_t index, std::uint8_t subindex) = 0;

    /// Set-up: 5F02h:1…4 come in the RPDO with this identifier from now on, or leave in this TPDO when they change.
    virtual void receive_words(std::uint32_t identifier) = 0;
    virtual void send_words(std::uint32_t identifier) = 0;

    /// The last frame that was taken from the queue.
    const Frame& last() const { return last_; }

  protected:
    Frame last_{};
};

}  // namespace canproof::bench
