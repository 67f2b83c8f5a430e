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
    block_size_ = block_size;
    has_crc_ = has_crc;
}

/// Adds the bytes of a segment that begins at `from` to the CRC. A repeated segment does not count again.
inline void SdoBlockUpload::check_full(const std::size_t from, const std::uint64_t frame) noexcept {
    if (from >= checked_) {
        crc_.add_segment(frame);
        checked_ = from + sdo::segment_capacity;
    }
}
inline void SdoBlockUpload::check_last(const std::size_t from) noexcept {
    if (from >= checked_) {
        crc_.add(value_.part(from, sdo::segment_capacity));
        checked_ = value_.size();
    }
}

void SdoBlockUpload::send(TransmitQueue& queue, const std::uint32_t id) noexcept {
    const std::size_t left = std::size_t{block_size_} - sent_;
    const std::size_t room = generated::canopen::sdo_block_queued - queue.size();
    const std::size_t turns = (left < room) ? left : room;
    std::size_t from = base_ + (sent_ * sdo::segment_capacity);
    for (std::size_t turn = 0U; (turn < turns) && !last_sent_; ++turn) {
        ++sent_;
        static_assert(implements<req::CO_SDO_048>);
        last_sent_ = (value_.size() - from) <= sdo::segment_capacity;
        const std::uint64_t frame = (get_le<max_frame_length>(value_, from) << 8U) | sent_;
        if (last_sent_) {
            check_last(from);
            static_cast<void>(queue.push(id, max_frame_length, frame | sdo::block_last_segment_flag));
        } else {
            check_full(from, frame);
            static_cast<void>(queue.push(id, max_frame_length, frame));
        }
        from += sdo::segment_capacity;
    }
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
