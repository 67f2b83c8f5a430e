// SPDX-License-Identifier: Apache-2.0
// The connection between this program and a device's image on the microcontroller (src/target/bridge).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "host/base/descriptor.hpp"
#include "host/sim/image/emulator.hpp"
#include "host/sim/image/message.hpp"

namespace canproof::host {

/// Reports that the image (the firmware on the microcontroller) has ended, does not answer, or behaves in a way that no
/// image built from this program's sources can.
class ImageFailed : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The first message of an image.
struct ImageGreeting {
    std::string device;     ///< name of the device in the catalogue
    std::size_t inputs{0};  ///< number of input signals
    std::size_t outputs{0};
    bool has_own_clock{false};  ///< whether the image acts at its own times, some time after a call
};

class ImageLink {
  public:
    /// Greatest time in ms for which an image may send nothing. An emulator that runs in an emulator takes seconds to
    /// start.
    static constexpr int patience_ms = 300000;

    /// Makes a link. `to` and `from` are ends of pipes to and from the image. `name` appears in messages.
    ImageLink(Descriptor to, Descriptor from, std::string name, Emulator emulator = {});

    const std::string& name() const { return name_; }
    /// Sends a message. Throws ImageFailed when the image has ended.
    void send(bridge::Message& message);
    /// Waits for the next message of the image. Throws ImageFailed when the image sends nothing for `patience_ms`, when
    /// it has ended, or when the message is invalid.
    bridge::Message receive();
    /// Reads the first message of the image. Throws ImageFailed when it is no greeting.
    ImageGreeting greeting();
    /// Throws ImageFailed, because this program does not understand the message.
    [[noreturn]] void refuse() const;

  private:
    void read(std::uint8_t* to, std::size_t count);

    Descriptor to_;
    Descriptor from_;
    std::string name_;
    Emulator emulator_;
};

}  // namespace canproof::host
