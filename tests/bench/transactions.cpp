#include "tests/bench/transactions.hpp"

#include <stdexcept>

#include "firmware/base/crc16.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"
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

/// One request whose answer begins with `command`.
void exchange(TestNode& node, const Frame& request, std::uint8_t command) {
    node.receive(request);
    expect(node.last().data[0] == command, "unexpected SDO answer");
}

void segmented_upload(TestNode& node) {
    static const Frame begin = frame_of("605#40015F0000000000");
    static const Frame even = frame_of("605#6000000000000000");
    static const Frame odd = frame_of("605#7000000000000000");
    exchange(node, begin, 0x41);
    for (int segment = 0; segment < 9; ++segment) {  // nine segments of seven bytes, then the 64th
        node.receive(segment % 2 == 0 ? even : odd);
    }
    exchange(node, odd, 0x1D);  // one byte, the last segment
}

/// 64 KiB in sub-blocks of 127 segments.
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

void block_download(TestNode& node) {
    static const Frame begin = frame_of("605#C6005F0000000100");  // CRC, size 10000h
    const BlockData& data = block_data();
    exchange(node, begin, 0xA4);
    for (const Frame& segment : data.segments) {
        node.receive(segment);
    }
    exchange(node, data.end, 0xA1);
}

void block_upload(TestNode& node) {
    static const Frame begin = frame_of("605#A4005F007F000000");
    static const Frame start = frame_of("605#A300000000000000");
    static const Frame end = frame_of("605#A100000000000000");
    exchange(node, begin, 0xC6);
    node.receive(start);
    Frame acknowledge = data_frame(0x605, 8);
    acknowledge.data[0] = 0xA2;
    acknowledge.data[2] = sub_block;
    std::size_t left = block_data().segments.size();
    while (left > 0) {
        node.pump();
        const std::size_t block = std::min<std::size_t>(left, sub_block);
        expect((node.last().data[0] & 0x7FU) == block, "a sub-block ends with its last segment");
        left -= block;
        acknowledge.data[1] = static_cast<std::uint8_t>(block);
        node.receive(acknowledge);
    }
    expect((node.last().data[0] & 0xE3U) == 0xC1U, "the upload ends with its CRC");
    node.receive(end);
}

void map_words(TestNode& node, const std::string& communication, const std::string& mapping, const char* cob_id) {
    node.send("605#23" + communication + "0105020080");
    node.send("605#2F" + communication + "02FF000000");
    node.send("605#2B" + communication + "0300000000");  // no inhibit time, no event timer
    node.send("605#2B" + communication + "0500000000");
    node.send("605#2F" + mapping + "0000000000");
    for (const char* sub : {"01", "02", "03", "04"}) {
        node.send("605#23" + mapping + sub + "10" + sub + "025F");
    }
    node.send("605#2F" + mapping + "0004000000");
    node.send("605#23" + communication + "01" + cob_id);
    node.send("000#0105");
}

void receive_words(TestNode& node) {
    static const Frame words = frame_of("205#1111222233334444");
    node.receive(words);
}

void send_words(TestNode& node) {
    expect(node.change(0x5F02, 1) == 1 && node.last().id == 0x185, "one TPDO");
}

}  // namespace

TestNode::TestNode() {
    device_ = std::make_unique<host::GenericDevice>(test_part(), memory_, queue_);
    device_->lend(domain_index, 0, domain_size);
    device_->fill(domain_index, 0, block_data().bytes);
    device_->power_on(node_id, now);
    take_answers();
}

void TestNode::receive(const Frame& frame) {
    device_->receive(frame, now);
    take_answers();
}

void TestNode::send(const std::string& frame) {
    receive(frame_of(frame));
}

void TestNode::pump() {
    while (device_->next_deadline() <= now) {
        device_->advance(now);
        take_answers();
    }
}

std::size_t TestNode::change(std::uint16_t index, std::uint8_t subindex) {
    device_->node().process_value_changed(index, subindex, now);
    device_->advance(now);
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

const std::vector<Transaction>& transactions() {
    static const Frame upload = frame_of("605#4018100100000000");
    static const Frame download = frame_of("605#2B025F0134120000");
    const auto nothing = [](TestNode&) {};
    static const std::vector<Transaction> all{
        {"expedited upload u32", 300, 422, nothing, [](TestNode& node) { exchange(node, upload, 0x43); }},
        {"expedited download u16", 320, 429, nothing, [](TestNode& node) { exchange(node, download, 0x60); }},
        {"segmented upload, 64 bytes", 2600, 3905, nothing, segmented_upload},
        {"block download, 64 KiB", 1.6e6, 2.51e6, nothing, block_download},
        {"block upload, 64 KiB", 1.3e6, 1.84e6, nothing, block_upload},
        {"RPDO, 4 x 16 bit", 350, 509, [](TestNode& node) { map_words(node, "0014", "0016", "05020000"); },
         receive_words},
        {"TPDO, 4 x 16 bit", 300, 440, [](TestNode& node) { map_words(node, "0018", "001A", "85010000"); }, send_words},
    };
    return all;
}

}  // namespace canproof::bench
