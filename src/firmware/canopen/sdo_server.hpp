// SDO server: expedited and segmented transfer, both ways (CiA 301, 7.2.4.3). Every request gets at most one answer.
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

class SdoServer {
  public:
    /// Longest value that is transferred in segments; the longest string of the four dictionaries is shorter.
    static constexpr std::size_t buffer_size = 64U;

    SdoServer(ObjectAccess& objects, TransmitQueue& queue) noexcept : objects_{objects}, queue_{queue} {}

    /// Takes the identifiers of 600h + node-ID and 580h + node-ID and forgets any transfer.
    void reset(std::uint8_t node_id) noexcept;
    /// Forgets a running transfer without a word: the node left the states in which SDO works.
    void abandon() noexcept { state_ = State::idle; }

    bool is_request(const Frame& frame) const noexcept;
    /// Answers one request. Frames of other than eight bytes are ignored.
    void receive(const Frame& frame, Instant now) noexcept;
    /// Aborts a transfer that stalled for longer than the time-out.
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept { return (state_ == State::idle) ? never : deadline_; }

  private:
    enum class State : std::uint8_t { idle, downloading, uploading };

    void dispatch(ByteView request, Instant now) noexcept;
    void initiate_download(ByteView request, Instant now) noexcept;
    void download_expedited(ByteView request, std::uint8_t command, Instant now) noexcept;
    void download_segment(ByteView request, Instant now) noexcept;
    void finish_download(Instant now) noexcept;
    void initiate_upload(ByteView request, Instant now) noexcept;
    void upload_segment(ByteView request, Instant now) noexcept;

    void select(ByteView request) noexcept;
    void begin(State state, Instant now) noexcept;
    void refuse_segment() noexcept;
    bool toggle_fits(std::uint8_t command) noexcept;
    Frame answer(std::uint8_t command) const noexcept;
    void confirm_download() noexcept;
    void abort(AbortCode code) noexcept;
    void send(const Frame& frame) noexcept { static_cast<void>(queue_.push(frame)); }

    ObjectAccess& objects_;
    TransmitQueue& queue_;
    std::uint32_t request_id_{0U};
    std::uint32_t response_id_{0U};
    State state_{State::idle};
    Instant deadline_{};
    std::uint16_t index_{0U};
    std::uint8_t subindex_{0U};
    std::uint8_t toggle_{0U};
    std::size_t size_{0U};       ///< bytes of an upload, or capacity of the entry in a download
    std::size_t announced_{0U};  ///< size that the client announced; 0 when it did not
    std::size_t done_{0U};
    std::array<std::uint8_t, buffer_size> buffer_{};
};

}  // namespace canproof
