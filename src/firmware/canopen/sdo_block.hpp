// SPDX-License-Identifier: Apache-2.0
// The state that the two directions of SDO block transfer keep between frames (CiA 301, 7.2.4.3.9 to 7.2.4.3.15). This
// code handles the segments; SdoServer handles the object, the frames around the segments and time.
#pragma once

#include "firmware/base/bytes.hpp"
#include "firmware/base/crc16.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/canopen/sdo_protocol.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "firmware/canopen/vocabulary.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

/// Collects the segments of a block download in order. Segments out of order are ignored; the client repeats them.
class SdoBlockDownload {
  public:
    enum class Step : std::uint8_t {
        none,              ///< the sub-block continues
        acknowledge,       ///< the sub-block is over; the server must acknowledge it
        invalid_sequence,  ///< a sequence number that no segment can have
        too_long           ///< more data than the memory for the value can contain
    };

    /// Begins a transfer into the memory `place`.
    void start(MutableBytes place, bool checks_crc) noexcept;
    /// Processes one segment frame of eight bytes.
    Step take(const sdo::Request& segment) noexcept {
        static_assert(implements<req::CO_SDO_026> && implements<req::CO_SDO_027>);
        const std::uint64_t frame = field_le<0U, max_frame_length>(segment);
        const auto head = static_cast<std::uint32_t>(frame & 0xFFU);
        const bool last = (head & sdo::block_last_segment_flag) != 0U;
        const std::uint32_t sequence = head & ~sdo::block_last_segment_flag;
        if (sequence == 0U) {
            return Step::invalid_sequence;
        }
        if (sequence == (in_order_ + 1U)) {
            if (size_ > place_.size()) {
                return Step::too_long;  // an earlier segment did not fit, and only the last may have unused bytes
            }
            if (last) {
                complete_ = true;
            } else if (checks_crc_) {
                crc_.add_segment(frame);
            } else {
                // the client has not asked for a CRC
            }
            // One access writes eight bytes, and the next segment overwrites the eighth. Bytes that do not fit into the
            // memory are dropped. They may be the unused bytes of the last segment; finish() checks that.
            place_.put_le<max_frame_length>(size_, frame >> 8U);
            size_ += sdo::segment_capacity;
            in_order_ = static_cast<std::uint8_t>(sequence);
        }
        // The flag of the last segment makes `head` greater than every sequence number, which is at most 127.
        static_assert(implements<req::CO_SDO_050>);
        return (head >= generated::canopen::sdo_block_size) ? Step::acknowledge : Step::none;
    }
    /// Ends the sub-block. Returns the sequence number of the last segment received in order, 0 when there is none. The
    /// client continues after that segment.
    std::uint8_t acknowledge() noexcept;
    /// Returns whether the segment that the client marked as the last was received in order.
    bool complete() const noexcept { return complete_; }
    /// Ends the transfer; `unused` (0…7) bytes of the last segment hold no data. Returns 06070012h when the data is
    /// longer than the memory for it, 05040004h when the CRC was agreed on and is wrong, otherwise AbortCode::none.
    AbortCode finish(std::uint8_t unused, std::uint16_t crc) noexcept;
    /// Returns the number of bytes of all segments received in order; after finish() the length of the value.
    std::size_t size() const noexcept { return size_; }

    /// Returns whether the invariant between two requests holds (properties/invariants): the value is collected in the
    /// memory `place` and is at most one segment longer. It is complete when only the end request is missing
    /// (`is_ending`).
    bool is_consistent(MutableBytes place, bool is_ending) const noexcept;

  private:
    MutableBytes place_{};
    std::size_t size_{0U};
    Crc16 crc_{};                ///< excludes the last segment until finish() knows how many of its bytes are data
    std::uint8_t in_order_{0U};  ///< sequence number of the last segment received in order in this sub-block
    bool checks_crc_{false};
    bool complete_{false};
};

/// A value cut into the segments of a block upload.
class SdoBlockUpload {
  public:
    static_assert(implements<req::CO_SDO_024>);
    static constexpr bool is_block_size(const std::uint8_t count) noexcept {
        return (count > 0U) && (count <= generated::canopen::sdo_block_size);
    }

    /// Begins a transfer. `value` must remain until the transfer ends. `block_size` must satisfy is_block_size().
    /// `has_crc` says whether the transfer ends with the CRC of the data.
    void start(ByteView value, std::uint8_t block_size, bool has_crc) noexcept;
    /// Returns whether the present sub-block has another segment and the queue, with `queued` waiting frames, has room
    /// for it.
    bool can_send(const std::size_t queued) const noexcept {
        return !last_sent_ && (std::uint32_t{sent_} < block_size_) && (queued < generated::canopen::sdo_block_queued);
    }
    /// Queues the next segments with identifier `id` until the sub-block ends or the queue has no more room for
    /// segments. Call only while can_send() is true.
    void send(TransmitQueue& queue, std::uint32_t id) noexcept;
    /// Processes an acknowledgement: the client has received the segments of this sub-block up to `sequence` (0: none)
    /// and wants `block_size` segments next. Returns 05040003h when the segment `sequence` was not sent, 05040002h for
    /// a block size of 0 or above 127, otherwise AbortCode::none.
    AbortCode acknowledge(std::uint8_t sequence, std::uint8_t block_size) noexcept;
    /// Returns whether the whole value is acknowledged.
    bool complete() const noexcept { return complete_; }
    /// Returns how many bytes of the last segment hold no data, 0…7.
    std::uint8_t unused() const noexcept;
    static_assert(implements<req::CO_SDO_054>);
    /// Returns the CRC of all data sent, or 0 in a transfer without CRC.
    std::uint16_t crc() const noexcept { return has_crc_ ? crc_.value() : std::uint16_t{0U}; }

    /// Returns whether the invariant between two requests holds for an upload of `value` (properties/invariants): a
    /// sub-block has 1 to 127 segments, and the server has sent at most that many. Segments before the last one are
    /// full, and the last one contains the end of the value. A value of 0 bytes has one segment.
    bool is_consistent(ByteView value) const noexcept;

  private:
    ByteView value_{};
    std::size_t base_{0U};       ///< bytes before the present sub-block
    std::size_t unchecked_{0U};  ///< bytes that are not in the CRC yet: a repeated segment is not added again
    Crc16 crc_{};
    std::uint8_t block_size_{0U};
    std::uint8_t sent_{0U};  ///< segments of the present sub-block sent so far
    bool last_sent_{false};
    bool complete_{false};
    bool has_crc_{false};
};

}  // namespace canproof
