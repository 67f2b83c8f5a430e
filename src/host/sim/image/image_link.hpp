// SPDX-License-Identifier: Apache-2.0
// The connection of this program to a device's image on the microcontroller (src/target/bridge).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "host/base/descriptor.hpp"
#include "host/sim/image/emulator.hpp"
#include "host/sim/image/message.hpp"

namespace canproof::host {

/// Thrown when the image has ended, does not answer, or behaves unlike any image built from the sources of this
/// program.
class ImageFailed : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// First message of an image.
struct ImageGreeting {
    std::string device;     ///< its name in the catalogue
    std::size_t inputs{0};  ///< number of input signals
    std::size_t outputs{0};
};

class ImageLink {
  public:
    /// Milliseconds that an image may take for one message: emulation within emulation takes seconds to start.
    static constexpr int patience_ms = 300000;

    /// `to` and `from` are ends of pipes; `name` is for messages.
    ImageLink(Descriptor to, Descriptor from, std::string name, Emulator emulator = {});

    const std::string& name() const { return name_; }
    /// Throws ImageFailed when the image has ended.
    void send(bridge::Message& message);
    /// Waits for the image's next message. Throws ImageFailed.
    bridge::Message receive();
    /// Takes the first message of an image. Throws ImageFailed.
    ImageGreeting greeting();
    /// Throws ImageFailed for a message that this program does not understand.
    [[noreturn]] void refuse() const;

  private:
    void read(std::uint8_t* to, std::size_t count);

    Descriptor to_;
    Descriptor from_;
    std::string name_;
    Emulator emulator_;
};

}  // namespace canproof::host
