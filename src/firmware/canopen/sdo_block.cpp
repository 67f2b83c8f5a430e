// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/sdo_block.hpp"

#include "firmware/canopen/sdo_protocol.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

void SdoBlockDownload::start(const MutableBytes place, const bool checks_crc) noexcept {
    *this = SdoBlockDownload{};
    place_ = place;
    checks_crc_ = checks_crc;
}

std::uint8_t SdoBlockDownload::acknowledge() noexcept {
    const std::uint8_t sequence = in_order_;
    in_order_ = 0U;
    return sequence;
}

static_assert(implements<req::CO_SDO_028> && implements<req::CO_SDO_051>);
AbortCode SdoBlockDownload::finish(const std::uint8_t unused, const std::uint16_t crc) noexcept {
    const std::size_t checked = size_ - sdo::segment_capacity;
    size_ -= unused;
    if (size_ > place_.size()) {
        return AbortCode::too_long;
    }
    crc_.add(place_.view().part(checked, size_ - checked));
    return (checks_crc_ && (std::uint32_t{crc} != crc_.value())) ? AbortCode::crc_error : AbortCode::none;
}

void SdoBlockUpload::start(const ByteView value, const std::uint8_t block_size, const bool has_crc) noexcept {
    *this = SdoBlockUpload{};
    value_ = value;
    unchecked_ = value.size();
    block_size_ = block_size;
    has_crc_ = has_crc;
}

void SdoBlockUpload::send(TransmitQueue& queue, const std::uint32_t id) noexcept {
    constexpr std::size_t capacity = sdo::segment_capacity;
    const std::size_t left = std::size_t{block_size_} - sent_;
    const std::size_t room = generated::canopen::sdo_block_queued - queue.size();
    const std::size_t end = sent_ + ((left < room) ? left : room);
    ByteView rest = value_.part(base_ + (sent_ * capacity), value_.size());
    Crc16 crc{crc_};
    std::size_t sequence{sent_};
    while ((sequence != end) && (rest.size() > capacity)) {
        ++sequence;
        const std::uint64_t frame = (get_le<max_frame_length>(rest, 0U) << 8U) | sequence;
        if (rest.size() <= unchecked_) {  // a repeated segment is not added to the CRC again
            crc.add_segment(frame);
            unchecked_ = rest.size() - capacity;
        }
        static_cast<void>(queue.push_segment(id, frame));
        rest = rest.part(capacity, rest.size() - capacity);
    }
    if (sequence != end) {
        static_assert(implements<req::CO_SDO_048>);
        ++sequence;
        last_sent_ = true;
        if (rest.size() <= unchecked_) {
            crc.add(rest);
            unchecked_ = 0U;
        }
        const std::uint64_t frame = (get_le<max_frame_length>(rest, 0U) << 8U) | sequence;
        static_cast<void>(queue.push(id, max_frame_length, frame | sdo::block_last_segment_flag));
    }
    sent_ = static_cast<std::uint8_t>(sequence);
    crc_ = crc;
}

static_assert(implements<req::CO_SDO_022>);
static_assert(implements<req::CO_SDO_023>);
AbortCode SdoBlockUpload::acknowledge(const std::uint8_t sequence, const std::uint8_t block_size) noexcept {
    if (std::uint32_t{sequence} > sent_) {
        return AbortCode::invalid_sequence_number;
    }
    if (!is_block_size(block_size)) {
        return AbortCode::invalid_block_size;
    }
    const bool all = std::uint32_t{sequence} == sent_;
    complete_ = last_sent_ && all;
    last_sent_ = complete_;
    base_ += sequence * sdo::segment_capacity;
    sent_ = 0U;
    block_size_ = block_size;
    return AbortCode::none;
}

static_assert(implements<req::CO_SDO_038>);
std::uint8_t SdoBlockUpload::unused() const noexcept {
    const std::size_t in_last = value_.size() % sdo::segment_capacity;
    const bool full = (in_last == 0U) && !value_.empty();
    return static_cast<std::uint8_t>(full ? 0U : (sdo::segment_capacity - in_last));
}

}  // namespace canproof
