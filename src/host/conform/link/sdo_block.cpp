// SPDX-License-Identifier: Apache-2.0
// Block transfers of the SDO client.
#include <fmt/format.h>

#include <algorithm>

#include "host/conform/language/data_pattern.hpp"
#include "host/conform/language/functions.hpp"
#include "host/conform/link/sdo_client.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::size_t segment_size = 7;
constexpr std::size_t longest_value = std::size_t{1} << 20U;
constexpr std::uint8_t last_segment = 0x80U;
constexpr std::uint8_t highest_block_size = 127;

Bytes initiate(std::uint8_t command, const ObjectPlace& place) {
    Bytes bytes = multiplexer(place);
    bytes.insert(bytes.begin(), command);
    return bytes;
}

struct Block {
    Bytes data;  ///< data of all segments, including the padding of the last one
    std::uint8_t segments{0};
    bool last{false};
    std::uint32_t abort{0};
};

/// Receives the segments of one block, up to `size` or `most` of them, whichever is less. Ends early after the last
/// segment of the transfer or an abort. Throws SlaveFailed for a wrong segment number.
Block take_block(SdoClient& client, std::uint8_t size, std::size_t most) {
    Block block;
    while (!block.last && block.segments < std::min<std::size_t>(size, most)) {
        const Bytes segment = client.answer();
        if (const auto code = abort_code(segment)) {
            block.abort = *code;
            return block;
        }
        const unsigned number = segment.front() & 0x7FU;
        if (number != block.segments + 1U) {
            throw SlaveFailed{
                fmt::format("the slave sent segment {} of a block instead of segment {}", number, block.segments + 1U)};
        }
        ++block.segments;
        block.last = (segment.front() & last_segment) != 0U;
        block.data.insert(block.data.end(), segment.begin() + 1, segment.end());
    }
    return block;
}

void check_end(const Bytes& end, SdoOutcome& outcome, bool with_crc) {
    if ((end.front() & 0xE3U) != 0xC1U) {
        throw SlaveFailed{fmt::format("the slave ended a block upload with {}; the first byte must be C1h, C5h … DDh",
                                      hex_words(end))};
    }
    const std::size_t unused = (end.front() >> 2U) & 7U;
    const auto left_over = static_cast<std::ptrdiff_t>(std::min(unused, outcome.data.size()));
    outcome.data.erase(outcome.data.end() - left_over, outcome.data.end());
    const std::int64_t crc = from_little_endian(end, 1, 2);
    const std::uint16_t wanted = block_crc(outcome.data);
    if (with_crc && crc != wanted) {
        throw SlaveFailed{fmt::format("the slave sent the CRC {:04X}h, but the CRC of the {} bytes is {:04X}h", crc,
                                      outcome.data.size(), wanted)};
    }
}

}  // namespace

SdoOutcome SdoClient::block_read(const ObjectPlace& place, const BlockRead& how) {
    Bytes first = initiate(how.crc ? 0xA4U : 0xA0U, place);
    first.push_back(how.block_sizes.front());
    first.push_back(how.switch_size);
    send(first);
    const Bytes begun = answer();
    SdoOutcome outcome;
    if (const auto code = abort_code(begun)) {
        outcome.abort = *code;
        return outcome;
    }
    if ((begun.front() & 0xF0U) == 0x40U && how.switch_size != 0) {
        outcome = take_upload(place, begun);
        outcome.switched = true;
        return outcome;
    }
    if ((begun.front() & 0xF9U) != 0xC0U) {
        throw SlaveFailed{
            fmt::format("the slave answered a block upload with {}; the first byte must be C0h, C2h, C4h or C6h{}",
                        hex_words(begun), how.switch_size != 0 ? ", or 40h to 4Fh to switch to a normal upload" : "")};
    }
    want_object(begun, place, "the answer");
    send({0xA3U});
    std::size_t seen = 0;
    for (bool last = false; !last;) {
        const std::uint8_t size = how.block_sizes[std::min<std::size_t>(outcome.blocks, how.block_sizes.size() - 1)];
        const Block block = take_block(*this, size, how.break_after ? *how.break_after - seen : size);
        seen += block.segments;
        if (block.abort != 0 || (how.break_after && seen >= *how.break_after)) {
            outcome.abort = block.abort != 0 ? block.abort : timed_out;
            return outcome;
        }
        const bool cut = outcome.blocks == 0 && how.short_ack && *how.short_ack < block.segments;
        const std::uint8_t taken = cut ? *how.short_ack : block.segments;
        outcome.data.insert(outcome.data.end(), block.data.begin(),
                            block.data.begin() + static_cast<std::ptrdiff_t>(taken * segment_size));
        last = block.last && !cut;
        ++outcome.blocks;
        send({0xA2U, taken, how.block_sizes[std::min<std::size_t>(outcome.blocks, how.block_sizes.size() - 1)]});
        if (outcome.data.size() > longest_value || outcome.blocks > longest_value / segment_size) {
            throw SlaveFailed{fmt::format("the block upload does not end within {} bytes and {} blocks", longest_value,
                                          longest_value / segment_size)};
        }
    }
    const Bytes end = answer();
    if (const auto code = abort_code(end)) {
        outcome.abort = *code;
        return outcome;
    }
    check_end(end, outcome, how.crc && (begun.front() & 0x04U) != 0U);
    if ((begun.front() & 0x02U) != 0U &&
        from_little_endian(begun, 4, 4) != static_cast<std::int64_t>(outcome.data.size())) {
        throw SlaveFailed{fmt::format("the slave announced {} bytes, but sent {}", from_little_endian(begun, 4, 4),
                                      outcome.data.size())};
    }
    send({0xA1U});
    return outcome;
}

namespace {

/// Sends the blocks of a download, with the transmission errors that a case requests (such as a lost segment).
class BlockSender {
  public:
    BlockSender(Link& link, std::uint32_t id, const Bytes& data, const BlockWrite& how)
        : link_{link}, id_{id}, data_{data}, how_{how} {}

    std::size_t segments() const { return std::max<std::size_t>(1, (data_.size() + segment_size - 1) / segment_size); }
    /// Sends up to `size` segments from number `from` on. The numbers in the frames count from 1 in each block. Returns
    /// false when the transfer ends early.
    bool send_block(std::size_t from, std::uint8_t size, bool first) {
        const std::size_t count = std::min<std::size_t>(size, segments() - from);
        for (std::size_t i = 1; i <= count; ++i) {
            if (how_.break_after && sent_ == *how_.break_after) {
                return false;
            }
            const bool lost = first && ((how_.lose && *how_.lose == i) || (how_.lose_last && i == count));
            const bool twice = first && how_.repeat && *how_.repeat == i;
            for (int copy = 0; copy < (lost ? 0 : twice ? 2 : 1); ++copy) {
                send_segment(from + i - 1, static_cast<std::uint8_t>(i));
            }
            ++sent_;
        }
        return true;
    }

  private:
    void send_segment(std::size_t at, std::uint8_t number) {
        Frame frame = data_frame(id_, max_frame_length);
        frame.data.fill(how_.padding);
        frame.data[0] = static_cast<std::uint8_t>(number | (at + 1 == segments() ? last_segment : 0U));
        const std::size_t start = at * segment_size;
        const std::size_t count = std::min(segment_size, data_.size() - std::min(start, data_.size()));
        std::copy_n(data_.begin() + static_cast<std::ptrdiff_t>(start), count, frame.data.begin() + 1);
        link_.send(frame);
    }

    Link& link_;
    std::uint32_t id_;
    const Bytes& data_;
    const BlockWrite& how_;
    std::size_t sent_{0};
};

}  // namespace

/// Ends a download in which the client left out the last segment of the first block on purpose, so that the server
/// still waits for this segment. Waits for the server's abort. Sends an abort when no answer comes in time. Returns the
/// abort code; 0 when another answer comes.
SdoOutcome SdoClient::give_up(const ObjectPlace& place) {
    SdoOutcome outcome;
    const auto said = link_.take(answer_key(), link_.now() + timeout_);
    outcome.abort = timed_out;
    if (said) {
        outcome.abort = abort_code(data_of(said->frame)).value_or(0);
    } else {
        Bytes bytes = initiate(0x80U, place);
        const Bytes code = little_endian(timed_out, 4);
        bytes.insert(bytes.end(), code.begin(), code.end());
        send(bytes);
    }
    return outcome;
}

SdoOutcome SdoClient::block_write(const ObjectPlace& place, const Bytes& data, const BlockWrite& how) {
    Bytes first = initiate(
        static_cast<std::uint8_t>(0xC0U | (how.crc || how.wrong_crc ? 4U : 0U) | (how.without_size ? 0U : 2U)), place);
    const Bytes size =
        little_endian(how.without_size ? 0 : how.size.value_or(static_cast<std::uint32_t>(data.size())), 4);
    first.insert(first.end(), size.begin(), size.end());
    send(first);
    Bytes got = answer();
    SdoOutcome outcome;
    BlockSender sender{link_, 0x600U + node_id_, data, how};
    std::size_t done = 0;
    std::uint8_t wanted = 0xA0U;
    while (abort_code(got).value_or(0) == 0 && done < sender.segments()) {
        const bool begins = wanted == 0xA0U;
        const std::uint8_t block_size = begins ? got[4] : got[2];
        if ((got.front() & (begins ? 0xFBU : 0xFFU)) != wanted || block_size == 0 || block_size > highest_block_size) {
            throw SlaveFailed{
                fmt::format("the slave answered a block download with {}; an answer must begin with {} and contain a "
                            "block size of 1 to 127",
                            hex_words(got), begins ? "A0h or A4h" : "A2h")};
        }
        if (begins) {
            want_object(got, place, "the answer");
        }
        if (!sender.send_block(done, block_size, outcome.blocks == 0)) {
            outcome.abort = timed_out;
            return outcome;
        }
        const std::size_t count = std::min<std::size_t>(block_size, sender.segments() - done);
        if (outcome.blocks == 0 && how.lose_last) {
            return give_up(place);
        }
        got = answer();
        const bool lossy = outcome.blocks == 0 && how.lose && *how.lose <= count;
        const std::size_t all = lossy ? *how.lose - 1U : count;
        if (!abort_code(got) && got[1] != all) {
            throw SlaveFailed{fmt::format("the slave acknowledged {} segments instead of {}", got[1], all)};
        }
        done += all;
        ++outcome.blocks;
        wanted = 0xA2U;
    }
    if (!abort_code(got)) {
        const std::size_t unused = sender.segments() * segment_size - data.size();
        const std::uint16_t crc = how.crc || how.wrong_crc ? block_crc(data) : std::uint16_t{0};
        Bytes end{static_cast<std::uint8_t>(0xC1U | (unused << 2U))};
        const Bytes sum = little_endian(how.wrong_crc ? crc ^ 1 : crc, 2);
        end.insert(end.end(), sum.begin(), sum.end());
        send(end);
        got = answer();
    }
    outcome.abort = abort_code(got).value_or(0);
    if (outcome.abort == 0 && got.front() != 0xA1U) {
        throw SlaveFailed{fmt::format(
            "the slave answered the end of a block download with {}; the first byte must be A1h", hex_words(got))};
    }
    return outcome;
}

}  // namespace canproof::host::conform
