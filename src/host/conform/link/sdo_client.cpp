// SPDX-License-Identifier: Apache-2.0
#include "host/conform/link/sdo_client.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host::conform {

namespace {

constexpr std::uint8_t abort_transfer = 0x80U;
constexpr std::uint8_t toggle = 0x10U;
constexpr std::size_t segment_size = 7;
constexpr std::size_t most_expedited = 4;
constexpr std::size_t longest_value = std::size_t{1} << 20U;

Bytes request(std::uint8_t command, const ObjectPlace& place) {
    Bytes bytes = multiplexer(place);
    bytes.insert(bytes.begin(), command);
    return bytes;
}

void append(Bytes& to, const Bytes& from, std::size_t start, std::size_t count) {
    const auto first = from.begin() + static_cast<std::ptrdiff_t>(start);
    to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

std::optional<std::uint32_t> abort_code(const Bytes& answer) {
    if (answer.empty() || answer.front() != abort_transfer) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(from_little_endian(answer, 4, 4));
}

std::string abort_words(std::uint32_t code) {
    return fmt::format("abort {:08X}h", code);
}

void want_object(const Bytes& answer, const ObjectPlace& place, const char* what) {
    const ObjectPlace said{static_cast<std::uint16_t>(from_little_endian(answer, 1, 2)), answer[3]};
    if (!(said == place)) {
        throw SlaveFailed{
            fmt::format("{} contains the object {} instead of {}", what, words_of(said), words_of(place))};
    }
}

void SdoClient::send(const Bytes& bytes) {
    const FrameKey key = answer_key();
    const FrameRecord* const unasked = link_.peek([&](const FrameRecord& one) { return key.fits(one.frame); });
    if (unasked != nullptr && !allows_unasked_) {
        throw SlaveFailed{fmt::format("the SDO server sent {} without being asked",
                                      hex_words(Bytes(unasked->frame.data.begin(), unasked->frame.data.end())))};
    }
    link_.forget(key);
    Frame frame = data_frame(0x600U + node_id_, max_frame_length);
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    link_.send(frame);
}

FrameRecord SdoClient::answer_frame(Duration within) {
    const auto record = link_.take(answer_key(), link_.now() + within);
    if (!record) {
        throw NoAnswer{fmt::format("no answer of the SDO server came within {} ms", within.us / 1000U)};
    }
    ++journal_.judged;
    journal_.times["SDO answer"].add(elapsed(link_.last_sent(), record->time).us, within.us);
    if (record->frame.length != max_frame_length) {
        throw SlaveFailed{fmt::format("an SDO answer has {} bytes instead of 8", record->frame.length)};
    }
    return *record;
}

Bytes SdoClient::answer(Duration within) {
    const Frame frame = answer_frame(within).frame;
    return Bytes(frame.data.begin(), frame.data.end());
}

SdoOutcome SdoClient::read(const ObjectPlace& place) {
    send(request(0x40U, place));
    return take_upload(place, answer());
}

/// Completes an upload from its first answer: an abort, an expedited value, or the start of segments.
SdoOutcome SdoClient::take_upload(const ObjectPlace& place, const Bytes& first) {
    SdoOutcome outcome;
    if (const auto code = abort_code(first)) {
        want_object(first, place, "the abort");
        outcome.abort = *code;
        return outcome;
    }
    const std::uint8_t command = first.front();
    if ((command & 0xF0U) != 0x40U) {
        throw SlaveFailed{
            fmt::format("the answer to an upload is {}; its first byte must be 40h to 4Fh", hex_words(first))};
    }
    want_object(first, place, "the answer");
    if ((command & 0x02U) != 0U) {
        const std::size_t unused = (command & 0x01U) != 0U ? (command >> 2U) & 3U : 0U;
        append(outcome.data, first, 4, most_expedited - unused);
        return outcome;
    }
    return read_segments(first);
}

SdoOutcome SdoClient::read_segments(const Bytes& first) {
    SdoOutcome outcome;
    const bool says_size = (first.front() & 0x01U) != 0U;
    const std::int64_t size = from_little_endian(first, 4, 4);
    bool last = false;
    for (std::uint8_t turn = 0; !last; turn ^= toggle) {
        send({static_cast<std::uint8_t>(0x60U | turn)});
        const Bytes segment = answer();
        if (const auto code = abort_code(segment)) {
            outcome.abort = *code;
            return outcome;
        }
        if ((segment.front() & 0xF0U) != turn) {
            throw SlaveFailed{
                fmt::format("the slave sent the segment {0}; the first byte must be {1}0h to {1}Fh, because the toggle "
                            "bit must be {1}",
                            hex_words(segment), turn >> 4U)};
        }
        append(outcome.data, segment, 1, segment_size - ((segment.front() >> 1U) & 7U));
        last = (segment.front() & 0x01U) != 0U;
        if (outcome.data.size() > longest_value) {
            throw SlaveFailed{fmt::format("the upload does not end within {} bytes", longest_value)};
        }
    }
    if (says_size && size != static_cast<std::int64_t>(outcome.data.size())) {
        throw SlaveFailed{fmt::format("the slave announced {} bytes, but sent {}", size, outcome.data.size())};
    }
    return outcome;
}

SdoOutcome SdoClient::write(const ObjectPlace& place, const Bytes& data, Transfer transfer) {
    if (transfer == Transfer::block) {
        return block_write(place, data, {});
    }
    const bool fits = !data.empty() && data.size() <= most_expedited;
    if (transfer == Transfer::segments || !fits) {
        return write_segments(place, data);
    }
    Bytes bytes = request(static_cast<std::uint8_t>(0x23U | ((most_expedited - data.size()) << 2U)), place);
    bytes.insert(bytes.end(), data.begin(), data.end());
    send(bytes);
    const Bytes confirmed = answer();
    want_object(confirmed, place, "the answer");
    SdoOutcome outcome;
    outcome.abort = abort_code(confirmed).value_or(0);
    if (outcome.abort == 0 && confirmed.front() != 0x60U) {
        throw SlaveFailed{
            fmt::format("the answer to a download is {}; its first byte must be 60h", hex_words(confirmed))};
    }
    return outcome;
}

SdoOutcome SdoClient::write_segments(const ObjectPlace& place, const Bytes& data) {
    SdoOutcome outcome;
    Bytes first = request(0x21U, place);
    const Bytes size = little_endian(static_cast<std::int64_t>(data.size()), 4);
    first.insert(first.end(), size.begin(), size.end());
    send(first);
    Bytes got = answer();
    want_object(got, place, "the answer");
    std::size_t sent = 0;
    std::uint8_t turn = 0;
    bool last = false;
    for (std::uint8_t wanted = 0x60U; abort_code(got).value_or(0) == 0; got = answer()) {
        if (got.front() != wanted) {
            throw SlaveFailed{
                fmt::format("the slave answered a segmented download with {}; the first byte must be {:02X}h",
                            hex_words(got), wanted)};
        }
        if (last) {
            return outcome;
        }
        const std::size_t count = std::min(segment_size, data.size() - sent);
        last = sent + count == data.size();
        const auto unused = static_cast<std::uint8_t>(segment_size - count);
        Bytes segment{static_cast<std::uint8_t>(unsigned{turn} | (unsigned{unused} << 1U) | (last ? 1U : 0U))};
        append(segment, data, sent, count);
        send(segment);
        sent += count;
        wanted = static_cast<std::uint8_t>(0x20U | turn);
        turn ^= toggle;
    }
    outcome.abort = *abort_code(got);
    return outcome;
}

}  // namespace canproof::host::conform
