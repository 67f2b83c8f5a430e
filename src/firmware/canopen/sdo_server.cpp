#include "firmware/canopen/sdo_server.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/requirements.hpp"

namespace canproof {

namespace {

using generated::canopen::sdo_request_cob_id_base;
using generated::canopen::sdo_response_cob_id_base;
using generated::canopen::sdo_timeout_ms;

constexpr std::size_t data_position = 4U;     ///< first data byte of an initiate frame
constexpr std::size_t segment_capacity = 7U;  ///< data bytes of a segment
constexpr std::size_t expedited_capacity = 4U;
constexpr std::uint8_t toggle_bit = 0x10U;

// Client command specifiers: the upper three bits of byte 0.
constexpr std::uint8_t ccs_download_segment = 0U;
constexpr std::uint8_t ccs_initiate_download = 1U;
constexpr std::uint8_t ccs_initiate_upload = 2U;
constexpr std::uint8_t ccs_upload_segment = 3U;
constexpr std::uint8_t ccs_abort = 4U;

constexpr std::uint8_t scs_download_segment = 0x20U;
constexpr std::uint8_t scs_initiate_upload = 0x40U;
constexpr std::uint8_t scs_initiate_download = 0x60U;
constexpr std::uint8_t cs_abort = 0x80U;

constexpr std::uint8_t expedited_flag = 0x02U;
constexpr std::uint8_t size_flag = 0x01U;
constexpr std::uint8_t last_segment_flag = 0x01U;

}  // namespace

void SdoServer::reset(const std::uint8_t node_id) noexcept {
    request_id_ = sdo_request_cob_id_base + std::uint32_t{node_id};
    response_id_ = sdo_response_cob_id_base + std::uint32_t{node_id};
    abandon();
}

bool SdoServer::is_request(const Frame& frame) const noexcept {
    return !frame.extended && !frame.remote && (frame.id == request_id_);
}

void SdoServer::receive(const Frame& frame, const Instant now) noexcept {
    if (frame.length == max_frame_length) {
        dispatch(frame.payload(), now);
    }
}

void SdoServer::dispatch(const ByteView request, const Instant now) noexcept {
    switch (request[0] >> 5U) {
        case ccs_download_segment:
            download_segment(request, now);
            break;
        case ccs_initiate_download:
            initiate_download(request, now);
            break;
        case ccs_initiate_upload:
            initiate_upload(request, now);
            break;
        case ccs_upload_segment:
            upload_segment(request, now);
            break;
        case ccs_abort:
            abandon();
            break;
        default:  // block transfer, which this server does not offer, and the unassigned specifier 7
            select(request);
            abort(AbortCode::command_specifier);
            break;
    }
}

void SdoServer::select(const ByteView request) noexcept {
    abandon();  // a new initiate ends the transfer before it
    index_ = read_u16(request, 1U);
    subindex_ = request[3];
}

void SdoServer::begin(const State state, const Instant now) noexcept {
    state_ = state;
    toggle_ = 0U;
    done_ = 0U;
    deadline_ = now + milliseconds(sdo_timeout_ms);
}

void SdoServer::initiate_download(const ByteView request, const Instant now) noexcept {
    select(request);
    const std::uint8_t command = request[0];
    if ((command & expedited_flag) != 0U) {
        download_expedited(request, command, now);
        return;
    }
    const auto capacity = objects_.writable_size(index_, subindex_);
    if (!capacity.ok()) {
        abort(capacity.error());
        return;
    }
    size_ = capacity.value();
    announced_ = ((command & size_flag) != 0U) ? read_u32(request, data_position) : 0U;
    if (announced_ > size_) {
        abort(AbortCode::too_long);
        return;
    }
    if (size_ > buffer_size) {
        abort(AbortCode::out_of_memory);
        return;
    }
    begin(State::downloading, now);
    confirm_download();
}

void SdoServer::download_expedited(const ByteView request, const std::uint8_t command, const Instant now) noexcept {
    std::size_t length = expedited_capacity - ((command >> 2U) & 0x03U);
    if ((command & size_flag) == 0U) {
        // Size not shown: the entry's own length is meant.
        const auto capacity = objects_.writable_size(index_, subindex_);
        const bool shorter = capacity.ok() && (capacity.value() < expedited_capacity);
        length = shorter ? std::size_t{capacity.value()} : expedited_capacity;
    }
    const AbortCode code = objects_.write(index_, subindex_, request.part(data_position, length), now);
    if (code == AbortCode::none) {
        confirm_download();
    } else {
        abort(code);
    }
}

void SdoServer::download_segment(const ByteView request, const Instant now) noexcept {
    if (state_ != State::downloading) {
        refuse_segment();
        return;
    }
    const std::uint8_t command = request[0];
    if (!toggle_fits(command)) {
        return;
    }
    const ByteView data = request.part(1U, segment_capacity - ((command >> 1U) & 0x07U));
    if ((done_ + data.size()) > size_) {
        abort(AbortCode::too_long);
        return;
    }
    MutableBytes{buffer_}.copy(done_, data);
    done_ += data.size();
    deadline_ = now + milliseconds(sdo_timeout_ms);
    if ((command & last_segment_flag) != 0U) {
        finish_download(now);
    } else {
        send(answer(static_cast<std::uint8_t>(scs_download_segment | (command & toggle_bit))));
    }
}

void SdoServer::finish_download(const Instant now) noexcept {
    if ((announced_ != 0U) && (announced_ != done_)) {
        abort(AbortCode::length_mismatch);
        return;
    }
    const std::uint8_t toggled = static_cast<std::uint8_t>(toggle_ ^ toggle_bit);  // of the segment just taken
    const AbortCode code = objects_.write(index_, subindex_, ByteView{buffer_.data(), done_}, now);
    if (code == AbortCode::none) {
        abandon();
        send(answer(static_cast<std::uint8_t>(scs_download_segment | toggled)));
    } else {
        abort(code);
    }
}

void SdoServer::initiate_upload(const ByteView request, const Instant now) noexcept {
    select(request);
    const auto read = objects_.read(index_, subindex_);
    if (!read.ok()) {
        abort(read.error());
        return;
    }
    const ByteView value = read.value();
    if ((value.size() > 0U) && (value.size() <= expedited_capacity)) {
        const std::size_t unused = expedited_capacity - value.size();
        const std::size_t command = scs_initiate_upload | (unused << 2U) | expedited_flag | size_flag;
        Frame frame = answer(static_cast<std::uint8_t>(command));
        MutableBytes{frame.data}.copy(data_position, value);
        send(frame);
        return;
    }
    if (value.size() > buffer_size) {
        abort(AbortCode::out_of_memory);
        return;
    }
    // The value is taken as it stands now: a change during the transfer must not mix old and new bytes.
    MutableBytes{buffer_}.copy(0U, value);
    size_ = value.size();
    begin(State::uploading, now);
    Frame frame = answer(scs_initiate_upload | size_flag);
    write_le(MutableBytes{frame.data}, data_position, 4U, size_);
    send(frame);
}

void SdoServer::upload_segment(const ByteView request, const Instant now) noexcept {
    if (state_ != State::uploading) {
        refuse_segment();
        return;
    }
    const std::uint8_t command = request[0];
    if (!toggle_fits(command)) {
        return;
    }
    const ByteView segment = ByteView{buffer_.data(), size_}.part(done_, segment_capacity);
    done_ += segment.size();
    deadline_ = now + milliseconds(sdo_timeout_ms);
    const bool last = done_ == size_;
    const std::size_t unused = segment_capacity - segment.size();
    const std::size_t specifier = (command & toggle_bit) | (unused << 1U) | (last ? last_segment_flag : 0U);
    Frame frame = data_frame(response_id_, max_frame_length);
    frame.data[0] = static_cast<std::uint8_t>(specifier);
    MutableBytes{frame.data}.copy(1U, segment);
    send(frame);
    if (last) {
        abandon();
    }
}

void SdoServer::refuse_segment() noexcept {
    if (state_ == State::idle) {
        // No transfer is open, and a segment names no object: the abort must not name that of an earlier transfer.
        index_ = 0U;
        subindex_ = 0U;
    }
    abort(AbortCode::command_specifier);
}

bool SdoServer::toggle_fits(const std::uint8_t command) noexcept {
    if ((command & toggle_bit) != toggle_) {
        abort(AbortCode::toggle_not_alternated);
        return false;
    }
    toggle_ = static_cast<std::uint8_t>(toggle_ ^ toggle_bit);
    return true;
}

void SdoServer::advance(const Instant now) noexcept {
    if ((state_ != State::idle) && (deadline_ <= now)) {
        abort(AbortCode::time_out);
    }
}

Frame SdoServer::answer(const std::uint8_t command) const noexcept {
    Frame frame = data_frame(response_id_, max_frame_length);
    frame.data[0] = command;
    const bool names_object = (command & 0xE0U) != scs_download_segment;
    if (names_object) {
        write_le(MutableBytes{frame.data}, 1U, 2U, index_);
        frame.data[3] = subindex_;
    }
    return frame;
}

void SdoServer::confirm_download() noexcept {
    send(answer(scs_initiate_download));
}

void SdoServer::abort(const AbortCode code) noexcept {
    abandon();
    Frame frame = answer(cs_abort);
    write_le(MutableBytes{frame.data}, data_position, 4U, static_cast<std::uint32_t>(code));
    send(frame);
}

}  // namespace canproof
