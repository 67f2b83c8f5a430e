// SPDX-License-Identifier: Apache-2.0
// The connection of an image to the program that simulates its board.
#pragma once

#include "host/sim/image/message.hpp"

namespace canproof::target {

class Channel {
  public:
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    /// Makes the first message of an image. `name` is the name of the device, at most 32 characters.
    bool send(bridge::Message& message) { return message.is_sound() && write(message.sent()); }
    /// Runs the image: greets the program, takes the size of the parameter memory, and serves commands.
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

    /// Sends a message. Returns false when it is unsound or the program has ended.
    virtual bool read(std::uint8_t* to, std::size_t count) = 0;
    virtual bool write(ByteView bytes) = 0;
};

}  // namespace canproof::target
