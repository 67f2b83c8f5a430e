// SPDX-License-Identifier: Apache-2.0
#include "target/bridge/host_memory.hpp"

namespace canproof::target {

namespace {

using bridge::Kind;
using bridge::Message;

Message access(const Kind kind, const std::size_t at, const std::size_t count) {
    Message message{kind};
    message.put(static_cast<std::uint32_t>(at));
    message.put(static_cast<std::uint16_t>(count));
    return message;
}

}  // namespace

bool HostMemory::ask(Message& message) const {
    return channel_.send(message) && channel_.receive(message) && (message.kind() == Kind::stored) &&
           (message.take<std::uint8_t>() != 0U);
}

bool HostMemory::read(const std::size_t at, MutableBytes to) const {
    bool done{true};
    for (std::size_t from = 0U; done && (from < to.size()); from += bridge::most_memory_bytes) {
        const std::size_t count = std::min(to.size() - from, bridge::most_memory_bytes);
        Message message = access(Kind::read, at + from, count);
        done = ask(message);
        to.copy(from, message.take_bytes(count));
        done = done && message.is_sound();
    }
    return done;
}

bool HostMemory::write(const std::size_t at, const ByteView bytes) {
    bool done{true};
    for (std::size_t from = 0U; done && (from < bytes.size()); from += bridge::most_memory_bytes) {
        const ByteView some = bytes.part(from, bridge::most_memory_bytes);
        Message message = access(Kind::write, at + from, some.size());
        message.put_bytes(some);
        done = ask(message);
    }
    return done;
}

bool HostMemory::commit() {
    Message message{Kind::commit};
    return ask(message);
}

}  // namespace canproof::target
