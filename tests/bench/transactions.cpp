// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/transactions.hpp"

#include <stdexcept>

#include "firmware/base/crc16.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"
#include "tests/bench/floor/floor.hpp"
#include "tests/bench/test_dictionary.hpp"

namespace canproof::bench {

namespace {

constexpr std::uint8_t node_id = 5;
constexpr std::uint8_t sub_block = 127;

Frame frame_of(const std::string& text) {
    return host::parse_frame(text, "transaction");
}

void expect(bool holds, const char* what) {
    if (!holds) {
        throw std::logic_error{what};
    }
}

/// Sends one request and checks that its answer begins with `command`.
void exchange(Server& server, const Frame& request, std::uint8_t command) {
    server.receive(request);
    expect(server.last().data[0] == command, "unexpected SDO answer");
}

void segmented_upload(Server& server) {
    static const Frame begin = frame_of("605#40015F0000000000");
    static const Frame even = frame_of("605#6000000000000000");
    static const Frame odd = frame_of("605#7000000000000000");
    exchange(server, begin, 0x41);
    for (int segment = 0; segment < 9; ++segment) {  // nine segments of seven bytes, then (below) the 64th byte
        server.receive(segment % 2 == 0 ? even : odd);
    }
    exchange(server, odd, 0x1D);  // one byte, the last segment
}

/// The frames of a block download of 64 KiB: its segments, in sub-blocks of 127, and its end request.
struct BlockData {
    std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(domain_size);
    std::vector<Frame> segments;
    Frame end{};

    BlockData() {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes[i] = static_cast<std::uint8_t>((i * 7U) ^ (i >> 8U));
        }
        for (std::size_t at = 0; at < bytes.size(); at += 7) {
            Frame segment = data_frame(0x605, 8);
            const bool last = at + 7 >= bytes.size();
            segment.data[0] = static_cast<std::uint8_t>((segments.size() % sub_block) + 1 + (last ? 0x80 : 0));
            for (std::size_t i = 0; i < 7 && at + i < bytes.size(); ++i) {
                segment.data[i + 1] = bytes[at + i];
            }
            segments.push_back(segment);
        }
        Crc16 crc{};
        crc.add(ByteView{bytes.data(), bytes.size()});
        const std::size_t unused = segments.size() * 7 - bytes.size();
        end = data_frame(0x605, 8);
        end.data[0] = static_cast<std::uint8_t>(0xC1 | (unused << 2U));
        write_le(MutableBytes{end.data}, 1, 2, crc.value());
    }
};

const BlockData& block_data() {
    static const BlockData data;
    return data;
}

void block_download(Server& server) {
    static const Frame begin = frame_of("605#C6005F0000000100");  // CRC, size 10000h
    const BlockData& data = block_data();
    exchange(server, begin, 0xA4);
    for (const Frame& segment : data.segments) {
        server.receive(segment);
    }
    exchange(server, data.end, 0xA1);
}

void block_upload(Server& server) {
    static const Frame begin = frame_of("605#A4005F007F000000");
    static const Frame start = frame_of("605#A300000000000000");
    static const Frame end = frame_of("605#A100000000000000");
    exchange(server, begin, 0xC6);
    server.receive(start);
    Frame acknowledge = data_frame(0x605, 8);
    acknowledge.data[0] = 0xA2;
    acknowledge.data[2] = sub_block;
    std::size_t left = block_data().segments.size();
    while (left > 0) {
        server.pump();
        const std::size_t block = std::min<std::size_t>(left, sub_block);
        expect((server.last().data[0] & 0x7FU) == block, "a sub-block ends with its last segment");
        left -= block;
        acknowledge.data[1] = static_cast<std::uint8_t>(block);
        server.receive(acknowledge);
    }
    expect((server.last().data[0] & 0xE3U) == 0xC1U, "the upload ends with its CRC");
    server.receive(end);
}

void receive_same_words(Server& server) {
    static const Frame words = frame_of("205#1111222233334444");
    server.receive(words);
}

/// Sends an RPDO with four 16-bit values that differ from those of the previous call.
void receive_new_words(Server& server) {
    static Frame words = frame_of("205#0000000000000000");
    for (std::size_t i = 0; i < words.length; ++i) {
        ++words.data[i];
    }
    server.receive(words);
}

void prepare_to_receive(Server& server) {
    static const Frame second_word = frame_of("605#40025F0200000000");
    server.receive_words(0x205);
    receive_same_words(server);
    exchange(server, second_word, 0x4B);
    expect(server.last().data[4] == 0x22 && server.last().data[5] == 0x22, "the second word has arrived");
}

void send_changed_words(Server& server) {
    expect(server.change(0x5F02, 1) == 1 && server.last().id == 0x185, "one TPDO");
}

}  // namespace

TestNode::TestNode() {
    device_ = std::make_unique<host::GenericDevice>(test_part(), memory_, queue_);
    device_->lend(domain_index, 0, domain_size);
    device_->fill(domain_index, 0, block_data().bytes);
    device_->power_on(node_id, now_);
    take_answers();
}

void TestNode::receive(const Frame& frame) {
    device_->receive(frame, now_);
    take_answers();
}

void TestNode::pump() {
    while (device_->next_deadline() <= now_) {
        device_->advance(now_);
        take_answers();
    }
}

std::size_t TestNode::change(std::uint16_t index, std::uint8_t subindex) {
    device_->node().process_value_changed(index, subindex, now_);
    device_->advance(now_);
    return take_answers();
}

std::size_t TestNode::take_answers() {
    std::size_t count = 0;
    while (!queue_.empty()) {
        last_ = queue_.pop();
        ++count;
    }
    return count;
}

void TestNode::receive_words(std::uint32_t identifier) {
    map_words(0x1400, identifier);
}

void TestNode::send_words(std::uint32_t identifier) {
    map_words(0x1800, identifier);
}

/// Maps 5F02h:1…4 into the PDO whose communication parameters are at `communication` (1400h or 1800h), and starts the
/// node.
void TestNode::map_words(unsigned communication, std::uint32_t cob_id) {
    const auto write = [this](unsigned index, unsigned subindex, std::size_t size, std::uint32_t value) {
        Frame request = data_frame(0x605, 8);
        request.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
        write_le(MutableBytes{request.data}, 1, 2, index);
        request.data[3] = static_cast<std::uint8_t>(subindex);
        write_le(MutableBytes{request.data}, 4, 4, value);
        receive(request);
    };
    const unsigned mapping = communication + 0x200;
    write(communication, 1, 4, 0x80000000U | cob_id);
    write(communication, 2, 1, 255);
    write(communication, 3, 2, 0);  // no inhibit time
    write(communication, 5, 2, 0);  // no event timer
    write(mapping, 0, 1, 0);
    for (unsigned sub = 1; sub <= 4; ++sub) {
        write(mapping, sub, 4, 0x5F020010U | (sub << 8U));
    }
    write(mapping, 0, 1, 4);
    write(communication, 1, 4, cob_id);
    receive(frame_of("000#0105"));
}

std::unique_ptr<Server> make_floor() {
    return std::make_unique<Floor>(host::make_rows(test_part()), domain_index, block_data().bytes);
}

const std::vector<Transaction>& transactions() {
    static const Frame upload = frame_of("605#4018100100000000");
    static const Frame download = frame_of("605#2B025F0134120000");
    const auto nothing = [](Server&) {};
    static const std::vector<Transaction> all{
        {"expedited upload u32", 163, 165, nothing, [](Server& server) { exchange(server, upload, 0x43); }},
        {"expedited download u16", 238, 250, nothing, [](Server& server) { exchange(server, download, 0x60); }},
        {"segmented upload, 64 bytes", 1431, 1489, nothing, segmented_upload},
        {"block download, 64 KiB", 1.045e6, 1.18e6, nothing, block_download},
        {"block upload, 64 KiB", 0.955e6, 0.955e6, nothing, block_upload},
        {"RPDO, 4 x 16 bit, values as before", 136, 149, prepare_to_receive, receive_same_words},
        {"RPDO, 4 x 16 bit, new values", 171, 187, prepare_to_receive, receive_new_words},
        {"TPDO, 4 x 16 bit", 186, 192, [](Server& server) { server.send_words(0x185); }, send_changed_words},
    };
    return all;
}

}  // namespace canproof::bench
