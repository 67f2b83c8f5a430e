// SPDX-License-Identifier: Apache-2.0
// Reads the pcap and pcapng logs that canproof has written, block by block as the formats are described, and compares
// the frames.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "host/sim/run/frame_log.hpp"

namespace canproof::host {

namespace {

/// A frame as a log contains it.
struct Packet {
    std::uint64_t us{0};
    std::uint64_t id{0};  ///< identifier; bit 31 is set if it has 29 bits, bit 30 for a remote frame
    std::uint64_t length{0};
    std::string data;  ///< always eight bytes; bytes beyond the length of the frame are 0
    bool own{false};
};

bool operator==(const Packet& a, const Packet& b) {
    return a.us == b.us && a.id == b.id && a.length == b.length && a.data == b.data && a.own == b.own;
}

/// A text from whose beginning numbers are taken.
class Bytes {
  public:
    explicit Bytes(std::string text) : text_{std::move(text)} {}

    bool any() const { return !text_.empty(); }
    std::string take(std::size_t count) {
        RC_ASSERT(text_.size() >= count);
        std::string taken = text_.substr(0, count);
        text_.erase(0, count);
        return taken;
    }
    std::uint64_t little(std::size_t count) {
        std::uint64_t number = 0;
        const std::string bytes = take(count);
        for (std::size_t i = count; i-- > 0;) {
            number = 256U * number + static_cast<unsigned char>(bytes[i]);
        }
        return number;
    }
    std::uint64_t big(std::size_t count) {
        std::uint64_t number = 0;
        for (const char byte : take(count)) {
            number = 256U * number + static_cast<unsigned char>(byte);
        }
        return number;
    }

  private:
    std::string text_;
};

/// Takes a frame, 16 bytes, from the beginning of `bytes`.
void take_frame(Bytes& bytes, Packet& packet) {
    packet.id = bytes.big(4);
    packet.length = bytes.big(1);
    RC_ASSERT(bytes.big(3) == 0U);
    packet.data = bytes.take(8);
}

std::vector<Packet> read_pcapng(Bytes bytes) {
    std::vector<Packet> packets;
    while (bytes.any()) {
        const std::uint64_t type = bytes.little(4);
        const std::uint64_t size = bytes.little(4);
        Bytes block{bytes.take(size - 12U)};
        RC_ASSERT(bytes.little(4) == size);
        if (type != 6U) {
            continue;
        }
        Packet packet;
        RC_ASSERT(block.little(4) == 0U);  // the only interface
        packet.us = block.little(4) * 4294967296U;
        packet.us += block.little(4);
        RC_ASSERT(block.little(4) == 16U);
        RC_ASSERT(block.little(4) == 16U);
        take_frame(block, packet);
        RC_ASSERT(block.little(4) == 0x00040002U);  // option 2 (flags) with four bytes
        packet.own = block.little(4) == 2U;
        packets.push_back(packet);
    }
    return packets;
}

std::vector<Packet> read_pcap(Bytes bytes) {
    std::vector<Packet> packets;
    bytes.take(24);
    while (bytes.any()) {
        Packet packet;
        packet.us = bytes.little(4) * 1000000U;
        packet.us += bytes.little(4);
        RC_ASSERT(bytes.little(4) == 16U);
        RC_ASSERT(bytes.little(4) == 16U);
        take_frame(bytes, packet);
        packets.push_back(packet);
    }
    return packets;
}

/// Returns a frame whose data buffer also contains bytes beyond its length, which must not appear in the log.
Frame any_frame() {
    Frame frame{};
    frame.extended = *rc::gen::arbitrary<bool>();
    frame.remote = *rc::gen::arbitrary<bool>();
    frame.id = frame.extended ? *rc::gen::element<std::uint32_t>(0x000, 0x123, 0x1FFFFFFF)
                              : *rc::gen::element<std::uint32_t>(0x000, 0x123, 0x7FF);
    frame.length = *rc::gen::inRange<std::uint8_t>(0, 9);
    for (std::uint8_t& byte : frame.data) {
        byte = *rc::gen::element<std::uint8_t>(0x11, 0xA5, 0xFF);
    }
    return frame;
}

Packet packet_of(std::uint64_t us, const Frame& frame, bool own) {
    Packet packet{us, frame.id, frame.length, std::string(8, '\0'), own};
    packet.id += (frame.extended ? 0x80000000U : 0U) + (frame.remote ? 0x40000000U : 0U);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        packet.data[i] = static_cast<char>(frame.data[i]);
    }
    return packet;
}

}  // namespace

RC_GTEST_PROP(FrameLogLaw, PcapAndPcapngContainEachFrameAndItsTime, ()) {
    std::ostringstream pcapng;
    std::ostringstream pcap;
    FrameLog one{&pcapng, LogFormat::pcapng};
    FrameLog other{&pcap, LogFormat::pcap};
    one.begin("can0");
    other.begin("can0");
    std::vector<Packet> expected;
    for (int i = *rc::gen::inRange(0, 10); i > 0; --i) {
        const auto us = *rc::gen::element<std::uint64_t>(0, 999999, 1000000, 4294967295, 4294967296, 1700000000123456);
        const Frame frame = any_frame();
        const bool own = *rc::gen::arbitrary<bool>();
        one.write({Instant{us}, "can0", frame}, own);
        other.write({Instant{us}, "can0", frame}, own);
        expected.push_back(packet_of(us, frame, own));
    }
    RC_ASSERT(read_pcapng(Bytes{pcapng.str()}) == expected);
    for (Packet& packet : expected) {
        packet.own = false;  // the pcap format does not record who sent a frame
    }
    RC_ASSERT(read_pcap(Bytes{pcap.str()}) == expected);
}

}  // namespace canproof::host
