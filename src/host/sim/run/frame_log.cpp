// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/frame_log.hpp"

#include <algorithm>

namespace canproof::host {

namespace {

// Constants of the formats pcapng and pcap (IETF draft-ietf-opsawg-pcapng and -pcap) and of the link type
// LINKTYPE_CAN_SOCKETCAN.
constexpr std::uint32_t section_header = 0x0A0D0D0A;
constexpr std::uint32_t byte_order_magic = 0x1A2B3C4D;
constexpr std::uint32_t interface_description = 1;
constexpr std::uint32_t enhanced_packet = 6;
constexpr std::uint32_t linktype_can_socketcan = 227;
constexpr std::uint32_t option_if_name = 2;
constexpr std::uint32_t option_epb_flags = 2;
constexpr std::uint32_t inbound = 1;
constexpr std::uint32_t outbound = 2;
constexpr std::uint32_t extended_flag = 0x80000000U;
constexpr std::uint32_t remote_flag = 0x40000000U;
constexpr std::uint32_t pcap_microseconds = 0xA1B2C3D4;
constexpr std::uint32_t pcap_longest_packet = 0xFFFF;
constexpr std::size_t whole_word = 4;

bool ends_with(const std::string& path, const std::string& ending) {
    return path.size() > ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

/// The content of a pcapng block or of a part of a pcap file, as little-endian words.
class Block {
  public:
    void add32(std::uint32_t value) {
        for (unsigned shift = 0; shift < 32U; shift += 8U) {
            bytes_ += static_cast<char>((value >> shift) & 0xFFU);
        }
    }
    void add16(std::uint32_t low, std::uint32_t high) { add32(low | (high << 16U)); }
    /// Adds bytes, and zeros up to the next complete word of four bytes.
    void add(const std::string& bytes) {
        bytes_ += bytes;
        bytes_.resize((bytes_.size() + whole_word - 1) / whole_word * whole_word);
    }
    void write(std::ostream& out, std::uint32_t type) const {
        // number of bytes around the content of a block: its type once and its length twice, four bytes each
        constexpr std::uint32_t frame_of_block = 12;
        Block block;
        block.add32(type);
        block.add32(static_cast<std::uint32_t>(bytes_.size()) + frame_of_block);
        block.add(bytes_);
        block.add32(static_cast<std::uint32_t>(bytes_.size()) + frame_of_block);
        block.write_bare(out);
    }
    /// Writes the words without type and length, as a pcap file contains them.
    void write_bare(std::ostream& out) const { out.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size())); }

  private:
    std::string bytes_;
};

/// Returns the 16 bytes of a frame as libpcap captures it: identifier and flags in big-endian order, length, three zero
/// bytes, and eight bytes of data. Data bytes beyond the length are 0.
std::string packet_of(const Frame& frame) {
    const std::uint32_t id = frame.id | (frame.extended ? extended_flag : 0U) | (frame.remote ? remote_flag : 0U);
    std::string bytes;
    for (unsigned shift = 32; shift > 0; shift -= 8U) {
        bytes += static_cast<char>((id >> (shift - 8U)) & 0xFFU);
    }
    bytes += static_cast<char>(frame.length);
    bytes.append(3, '\0');
    for (std::size_t i = 0; i < frame.data.size(); ++i) {
        bytes += static_cast<char>(i < frame.length && !frame.remote ? frame.data[i] : 0U);
    }
    return bytes;
}

void write_pcap_header(std::ostream& out) {
    Block header;
    header.add32(pcap_microseconds);
    header.add16(2, 4);  // version 2.4 of the format
    header.add32(0);
    header.add32(0);
    header.add32(pcap_longest_packet);
    header.add32(linktype_can_socketcan);
    header.write_bare(out);
}

void write_pcap_packet(std::ostream& out, const LoggedFrame& frame) {
    constexpr std::uint64_t second = 1000000;
    const std::string packet = packet_of(frame.frame);
    Block record;
    record.add32(static_cast<std::uint32_t>(frame.time.us / second));
    record.add32(static_cast<std::uint32_t>(frame.time.us % second));
    record.add32(static_cast<std::uint32_t>(packet.size()));
    record.add32(static_cast<std::uint32_t>(packet.size()));
    record.add(packet);
    record.write_bare(out);
}

void write_pcapng_header(std::ostream& out, const std::string& interface) {
    Block section;
    section.add32(byte_order_magic);
    section.add16(1, 0);  // version 1.0 of the format
    section.add32(UINT32_MAX);
    section.add32(UINT32_MAX);  // the length of the section is not known
    section.write(out, section_header);
    Block description;
    description.add16(linktype_can_socketcan, 0);
    description.add32(0);  // the length of frames is not limited
    description.add16(option_if_name, static_cast<std::uint32_t>(interface.size()));
    description.add(interface);
    description.add32(0);  // end of the options; without an option, times are in microseconds
    description.write(out, interface_description);
}

void write_pcapng_packet(std::ostream& out, const LoggedFrame& frame, bool own) {
    const std::string packet = packet_of(frame.frame);
    Block block;
    block.add32(0);  // number of the interface; there is only one
    block.add32(static_cast<std::uint32_t>(frame.time.us >> 32U));
    block.add32(static_cast<std::uint32_t>(frame.time.us & UINT32_MAX));
    block.add32(static_cast<std::uint32_t>(packet.size()));
    block.add32(static_cast<std::uint32_t>(packet.size()));
    block.add(packet);
    block.add16(option_epb_flags, 4);
    block.add32(own ? outbound : inbound);
    block.add32(0);  // end of the options
    block.write(out, enhanced_packet);
}

}  // namespace

LogFormat log_format(const std::string& path, bool marks) {
    if (ends_with(path, ".pcapng")) {
        return LogFormat::pcapng;
    }
    if (ends_with(path, ".pcap")) {
        return LogFormat::pcap;
    }
    return marks ? LogFormat::marked : LogFormat::candump;
}

void FrameLog::begin(const std::string& interface) {
    if (out_ != nullptr && format_ == LogFormat::pcapng) {
        write_pcapng_header(*out_, interface);
    } else if (out_ != nullptr && format_ == LogFormat::pcap) {
        write_pcap_header(*out_);
    }
}

void FrameLog::write(const LoggedFrame& frame, bool own) {
    if (out_ == nullptr) {
        return;
    }
    switch (format_) {
        case LogFormat::pcapng:
            write_pcapng_packet(*out_, frame, own);
            return;
        case LogFormat::pcap:
            write_pcap_packet(*out_, frame);
            return;
        case LogFormat::marked:
            *out_ << format_candump_line(frame) << (own ? " T\n" : " R\n");
            return;
        case LogFormat::candump:
            *out_ << format_candump_line(frame) << '\n';
            return;
    }
}

}  // namespace canproof::host
