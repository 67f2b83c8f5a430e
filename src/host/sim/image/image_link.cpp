// SPDX-License-Identifier: Apache-2.0
#include "host/sim/image/image_link.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "host/base/write_all.hpp"

namespace canproof::host {

ImageLink::ImageLink(Descriptor to, Descriptor from, std::string name, Emulator emulator)
    : to_{std::move(to)}, from_{std::move(from)}, name_{std::move(name)}, emulator_{std::move(emulator)} {
    // after the end of the image, a write throws an exception and does not end the program
    std::signal(SIGPIPE, SIG_IGN);
}

void ImageLink::send(bridge::Message& message) {
    const ByteView bytes = message.sent();
    if (!write_all(to_.number(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()})) {
        throw ImageFailed{fmt::format("{} has ended; see the messages of the emulator", name_)};
    }
}

bridge::Message ImageLink::receive() {
    bridge::Message message;
    read(message.buffer(), bridge::Message::head);
    read(message.buffer() + bridge::Message::head, message.expected());
    message.filled();
    if (!message.is_sound()) {
        refuse();
    }
    return message;
}

ImageGreeting ImageLink::greeting() {
    bridge::Message message = receive();
    const auto protocol = message.take<std::uint32_t>();
    ImageGreeting greeting;
    greeting.has_own_clock = protocol == bridge::protocol_of_own_clock;
    if (message.kind() != bridge::Kind::greeting || !(greeting.has_own_clock || protocol == bridge::protocol)) {
        refuse();
    }
    greeting.inputs = message.take<std::uint8_t>();
    greeting.outputs = message.take<std::uint8_t>();
    const ByteView name = message.take_bytes(message.take<std::uint8_t>());
    if (!message.is_sound()) {
        refuse();
    }
    greeting.device.assign(name.data(), name.data() + name.size());
    return greeting;
}

void ImageLink::read(std::uint8_t* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
        pollfd waited{from_.number(), POLLIN, 0};
        const int ready = poll(&waited, 1, patience_ms);
        if (ready == 0) {
            throw ImageFailed{fmt::format(
                "{} has not answered for {} s; check that it is bridged_NAME.elf or zynqmp_NAME.elf of the device NAME",
                name_, patience_ms / 1000)};
        }
        const ssize_t got = ready < 0 ? -1 : ::read(from_.number(), to + done, count - done);
        if (got == 0 || (got < 0 && errno != EINTR)) {
            throw ImageFailed{fmt::format("{} has ended; see the messages of the emulator", name_)};
        }
        done += got < 0 ? 0 : static_cast<std::size_t>(got);
    }
}

void ImageLink::refuse() const {
    throw ImageFailed{fmt::format(
        "{} sent a message that this program does not understand; build both from the same sources", name_)};
}

}  // namespace canproof::host
