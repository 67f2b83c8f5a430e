// SPDX-License-Identifier: Apache-2.0
// The same small dictionary for two SDO servers. That of the firmware's server is generated from a requirements
// register; that of the naive server is written by hand.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/memory.hpp"
#include "properties/support/naive_sdo_server.hpp"

namespace canproof::naive {

constexpr std::uint8_t pair_node_id = 5;
constexpr std::uint16_t pair_domain = 0x2007;
constexpr std::size_t pair_domain_size = 2000;  ///< in bytes: two sub-blocks of 127 segments and a part of a third

/// Returns the files of the requirements register that describes this dictionary, each under its path. They are the
/// files of sdo_pair/spec, compiled into the program.
const host::SpecFiles& pair_files();

inline const host::Part& pair_part() {
    static const host::LoadResult loaded = host::load_register(pair_files());
    if (!loaded.faults.empty()) {
        throw std::logic_error{loaded.faults.front().text()};
    }
    return *loaded.content.part("pair");
}

/// Returns this dictionary for the naive server, written by hand.
inline Objects pair_model() {
    const auto number = [](std::size_t bytes, std::uint64_t value) {
        Entry entry;
        entry.capacity = bytes;
        entry.value = Bytes{};
        for (std::size_t i = 0; i < bytes; ++i) {
            entry.value->push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        }
        return entry;
    };
    const auto text = [](std::size_t capacity, const std::string& value) {
        Entry entry;
        entry.kind = Entry::Kind::text;
        entry.capacity = capacity;
        entry.value = Bytes{value.begin(), value.end()};
        return entry;
    };
    Objects objects;
    objects[0x1000][0] = number(4, 0x12345678);
    objects[0x1000][0].writable = false;
    objects[0x2000][0] = number(1, 2);
    objects[0x2000][0].limits = [](const Bytes& v) { return v[0] == 2 || v[0] == 8 ? 0U : 0x06090030U; };
    objects[0x2001][0] = number(2, 7);
    objects[0x2001][0].limits = [](const Bytes& v) {
        const int value = static_cast<std::int16_t>(v[0] + 256 * v[1]);
        return value > 100 ? 0x06090031U : (value < -100 ? 0x06090032U : 0U);
    };
    objects[0x2002][0] = number(4, 0);
    objects[0x2002][0].readable = false;
    objects[0x2003][0] = number(8, 0);
    objects[0x2004][0] = text(40, "abc");
    objects[0x2005][0] = text(15, "fifteen letters");
    objects[0x2005][0].writable = false;
    objects[0x2006][0] = text(72, "A value of seventy-two bytes is longer than what the server itself holds");
    objects[0x2006][0].has_memory = false;
    Entry domain;
    domain.kind = Entry::Kind::domain;
    domain.capacity = pair_domain_size;
    objects[pair_domain][0] = domain;
    domain.has_memory = false;
    objects[0x2008][0] = domain;
    objects[0x200A][0] = number(1, 3);
    objects[0x200A][0].writable = false;
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        objects[0x200A][sub] = number(1, 0);
    }
    return objects;
}

/// The SDO server of the firmware as a part of a whole node.
class Ours {
  public:
    Ours() : device{pair_part(), memory, queue} {
        device.lend(pair_domain, 0, pair_domain_size);
        restart();
    }

    /// Switches the node on at the time `start`, with an empty non-volatile memory and an empty DOMAIN.
    void restart(Instant start = {}) {
        queue = TransmitQueue{};
        now = start;
        std::fill(memory.bytes().begin(), memory.bytes().end(), std::uint8_t{0xFF});
        device.empty(pair_domain, 0);
        device.power_on(pair_node_id, now);
        answers();
    }
    std::vector<Message> ask(const Message& request) {
        Frame frame = data_frame(0x600U + pair_node_id, 8);
        frame.data = request;
        device.receive(frame, now);
        std::vector<Message> all = answers();
        keep_deadlines(now, all);
        return all;
    }
    std::vector<Message> pass(std::uint64_t ms) {
        std::vector<Message> all;
        pass(ms, all);
        return all;
    }
    /// Lets `ms` milliseconds pass and adds the SDO answers sent in this time to `all`.
    void pass(std::uint64_t ms, std::vector<Message>& all) {
        const Instant end = now + milliseconds(ms);
        keep_deadlines(end, all);
        now = end;
    }
    /// Returns the waiting SDO answers. Drops all other frames, which are not checked here.
    std::vector<Message> answers() {
        std::vector<Message> all;
        answers(all);
        return all;
    }
    /// Adds the waiting SDO answers to `all`.
    void answers(std::vector<Message>& all) {
        while (!queue.empty()) {
            const Frame frame = queue.pop();
            if (frame.id == 0x580U + pair_node_id) {
                all.push_back(frame.data);
            }
        }
    }

    host::Memory memory{256};
    TransmitQueue queue;
    Instant now{};
    host::GenericDevice device;

  private:
    void keep_deadlines(Instant end, std::vector<Message>& all) {
        while (device.next_deadline() <= end) {
            now = device.next_deadline() < now ? now : device.next_deadline();
            device.advance(now);
            answers(all);
        }
    }
};

}  // namespace canproof::naive
