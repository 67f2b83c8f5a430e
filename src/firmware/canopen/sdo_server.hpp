// SPDX-License-Identifier: Apache-2.0
// SDO server: expedited, segmented and block transfer in both directions (CiA 301, 7.2.4). Each request gets at most
// one answer. In addition to the answers, the server sends only the segments of a block upload, and an abort frame when
// a transfer times out.
#pragma once

#include <array>

#include "firmware/base/requirement.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/sdo_block.hpp"
#include "firmware/canopen/sdo_protocol.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

class SdoServer {
  public:
    /// Longest value, in bytes, that the server copies for a transfer.
    static constexpr std::size_t buffer_size = generated::canopen::sdo_buffer_size;

    /// Creates the server. Without `offers_block`, the server refuses block requests as unknown commands.
    SdoServer(ObjectAccess& objects, TransmitQueue& queue, const bool offers_block) noexcept
        : objects_{objects}, queue_{queue}, offers_block_{offers_block} {}

    /// Sets the identifiers to 600h + node-ID and 580h + node-ID and drops any transfer. No request is served before
    /// listen().
    void reset(std::uint8_t node_id) noexcept;
    /// Begins or ends the reception of requests.
    void listen(bool begins) noexcept;
    /// Drops a running transfer without an abort frame, for example when the node leaves the states in which SDO works.
    void abandon() noexcept {
        state_ = State::idle;
        idle_until_ = never;
    }

    bool is_request(const Frame& frame) const noexcept {
        static_assert(implements<req::CO_SDO_015>);
        return (frame.id == request_id_) && frame.is_plain();
    }
    /// Processes a segment of a running upload or block download, and ignores a frame without eight bytes. Returns
    /// false for any other request: initiate_upload(), initiate_download() or receive_command() processes it.
    bool receive_segment(const Frame& frame, const Instant now) noexcept {
        static_assert(implements<req::CO_SDO_007>);
        if (frame.length != max_frame_length) {
            return true;
        }
        if (state_ == State::block_downloading) {
            block_download_segment(frame.data, now);
            return true;
        }
        if ((state_ == State::uploading) && (sdo::command_of(frame.data) == sdo::ClientCommand::upload_segment)) {
            upload_segment(frame.data, now);
            return true;
        }
        return false;
    }
    /// Processes a request for which receive_segment() returns false and that begins no upload or download. It may
    /// write an entry.
    void receive_command(const sdo::Request& request, Instant now) noexcept;
    /// Processes a request that begins a download. It may write an entry.
    void initiate_download(const sdo::Request& request, Instant now) noexcept;
    /// Processes a request that begins an upload. `read` is the value of the object that the request names, or the
    /// reason why it cannot be read.
    void initiate_upload(const sdo::Request& request, const Result<ByteView, AbortCode>& read, Instant now) noexcept;
    /// Does the same as initiate_upload() for a number of `size` (1…4) bytes, without storing the object: the transfer
    /// ends with its answer.
    void upload_number(const sdo::NamedObject object, const std::uint32_t size, const std::uint32_t number) noexcept {
        static_assert(implements<req::CO_SDO_001> && implements<req::CO_SDO_012> && implements<req::CO_SDO_041>);
        abandon();
        send((std::uint64_t{number} << 32U) | object.bits | sdo::expedited_upload(size));
    }
    /// Queues the next segments of a block upload; aborts a transfer that stalls longer than the time-out.
    void advance(const Instant now) noexcept {
        if (state_ != State::idle) {
            proceed(now);
        }
    }
    /// Only queues the next segments of a block upload.
    void send_waiting(const Instant now) noexcept {
        if (state_ == State::block_uploading) {
            send_segments(now);
        }
    }
    /// Returns the time at which advance() is due. A block upload with segments to send is due as soon as the queue has
    /// room; the caller must call advance() when a frame has left the queue.
    Instant next_deadline() const noexcept {
        if (state_ == State::idle) {
            return never;
        }
        return can_send_segment() ? last_progress_ : deadline();
    }
    /// Returns a time before which only send_waiting() has work to do. A request of a running transfer moves the
    /// time-out to a later time, but this value changes only in advance().
    Instant idle_until() const noexcept { return idle_until_; }

    /// Returns whether the invariant between two requests holds (properties/invariants): a download is at a position
    /// within its memory, and the toggle bit is 0 or 10h. Without a transfer there is no deadline. The lowest byte of
    /// the stored object is 0, because an answer has its command there. A block transfer is consistent.
    bool is_consistent() const noexcept;
    /// Returns whether a transfer is open (properties/invariants).
    bool has_transfer() const noexcept;

  private:
    enum class State : std::uint8_t {
        idle,
        downloading,
        uploading,
        block_downloading,      ///< segments arrive
        block_download_ending,  ///< all segments are acknowledged; the server waits for the end with the CRC
        block_upload_starting,  ///< the server waits for "start"
        block_uploading,        ///< segments are sent; the server waits for an acknowledgement
        block_upload_ending     ///< the CRC is sent; the server waits for the confirmation
    };

    void proceed(Instant now) noexcept;
    void download_in_segments(const sdo::Request& request, Instant now) noexcept;
    void download_expedited(const sdo::Request& request, Instant now) noexcept;
    /// Returns the number of data bytes in an expedited download.
    std::size_t expedited_length(std::uint8_t command) const noexcept;
    void download_segment(const sdo::Request& request, Instant now) noexcept;
    void upload_segment(const sdo::Request& request, Instant now) noexcept;
    /// Sends the last segment and ends the upload. Not inlined, because most segments are not the last.
    [[gnu::noinline]] void upload_last_segment(std::uint32_t toggle) noexcept;

    // Block transfer, defined in sdo_server_block.cpp.
    void block_download(const sdo::Request& request, Instant now) noexcept;
    void initiate_block_download(const sdo::Request& request, Instant now) noexcept;
    void block_download_segment(const sdo::Request& request, Instant now) noexcept;
    void end_block_download(const sdo::Request& request, Instant now) noexcept;
    void block_upload(const sdo::Request& request, Instant now) noexcept;
    void initiate_block_upload(const sdo::Request& request, Instant now) noexcept;
    void acknowledge_block_upload(const sdo::Request& request, Instant now) noexcept;
    void send_segments(Instant now) noexcept;
    bool can_send_segment() const noexcept {
        return (state_ == State::block_uploading) && sent_.can_send(queue_.size());
    }

    void select(const sdo::Request& request) noexcept {
        static_assert(implements<req::CO_SDO_012>);
        abandon();  // a new initiate ends the previous transfer
        static_assert(implements<req::CO_SDO_041>);
        object_ = sdo::named_object(request);
    }
    void begin(State state, Instant now) noexcept;
    /// Finds the memory for a download of the selected entry. `announced`: the size that the client gave, if
    /// `has_size`. Returns an abort code when the entry cannot be written or the value does not fit, otherwise
    /// AbortCode::none.
    AbortCode open_download(bool has_size, std::uint32_t announced) noexcept;
    /// Writes the first `size` downloaded bytes to the entry. Returns 06070010h when the client announced another size,
    /// otherwise the result of the write.
    AbortCode commit(std::size_t size, Instant now) noexcept;
    /// Returns the value for this transfer. A short value is copied, so that a change during the transfer cannot mix
    /// old and new bytes; a long value is read in place.
    ByteView keep(ByteView value) noexcept;

    void refuse_command() noexcept;
    bool toggle_fits(std::uint8_t command) noexcept;
    Instant deadline() const noexcept { return last_progress_ + milliseconds(generated::canopen::sdo_timeout_ms); }
    /// Sends a frame with the eight bytes of `bytes`; its least significant byte becomes byte 0.
    void send(std::uint64_t bytes) noexcept;
    /// Sends a frame with `command`, index, sub-index and four bytes of data.
    void answer_object(const std::uint32_t command, const std::uint32_t data = 0U) noexcept {
        static_assert(implements<req::CO_SDO_041>);
        send((std::uint64_t{data} << 32U) | object_.bits | command);
    }
    void abort(AbortCode code) noexcept;

    static constexpr std::uint32_t nobody = UINT32_MAX;  ///< not the identifier of any frame

    ObjectAccess& objects_;
    TransmitQueue& queue_;
    std::uint32_t request_id_{nobody};  ///< `nobody` while no request is served
    std::uint32_t response_id_{0U};
    bool offers_block_;
    State state_{State::idle};
    Instant last_progress_{};
    Instant idle_until_{never};
    sdo::NamedObject object_{};
    std::uint8_t toggle_{0U};
    bool has_size_{false};       ///< the client announced the size of its download
    std::size_t announced_{0U};  ///< size that the client has announced
    std::size_t done_{0U};       ///< bytes downloaded in segments
    MutableBytes place_{};       ///< where a download is collected
    ByteView value_{};           ///< the value of a block upload; the rest of the value of an upload in segments
    SdoBlockDownload received_{};
    SdoBlockUpload sent_{};
    std::array<std::uint8_t, buffer_size> buffer_{};
};

}  // namespace canproof
