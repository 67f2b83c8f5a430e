// SPDX-License-Identifier: Apache-2.0
// The connection of an image to the program that simulates its board.
#pragma once

#include "host/sim/image/message.hpp"

namespace canproof::target {

class Channel {
  public:
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    /// Sends a message. Returns false when the message is invalid or the program on the host has ended.
    bool send(bridge::Message& message) { return message.is_sound() && write(message.sent()); }
    /// Waits for the next message. Returns false when the program on the host has ended or sends an invalid message.
    bool receive(bridge::Message& message) {
        message = bridge::Message{};
        bool done = read(message.buffer(), bridge::Message::head);
        done = done && read(message.buffer() + bridge::Message::head, message.expected());
        message.filled();
        return done && message.is_sound();
    }

  protected:
    Channel() = default;
    ~Channel() = default;

    /// Waits until all `count` bytes are read. Returns false when the program on the host has ended.
    virtual bool read(std::uint8_t* to, std::size_t count) = 0;
    virtual bool write(ByteView bytes) = 0;
};

}  // namespace canproof::target
