// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/sdo_server.hpp"

#include "firmware/canopen/sdo_protocol.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

using generated::canopen::sdo_request_cob_id_base;
using generated::canopen::sdo_response_cob_id_base;
using sdo::ClientCommand;

}  // namespace

void SdoServer::reset(const std::uint8_t node_id) noexcept {
    request_id_ = nobody;
    response_id_ = sdo_response_cob_id_base + std::uint32_t{node_id};
    abandon();
}

void SdoServer::listen(const bool begins) noexcept {
    const std::uint32_t node_id = response_id_ - sdo_response_cob_id_base;
    request_id_ = begins ? (sdo_request_cob_id_base + node_id) : nobody;
}

static_assert(implements<req::CO_SDO_035>);
static_assert(implements<req::CO_SDO_006>);
static_assert(implements<req::CO_SDO_013>);
void SdoServer::receive_command(const sdo::Request& request, const Instant now) noexcept {
    switch (sdo::command_of(request)) {
        case ClientCommand::download_segment:
            download_segment(request, now);
            break;
        case ClientCommand::upload_segment:
            refuse_command();  // receive_segment() has already served the segments of a running upload
            break;
        case ClientCommand::abort:
            abandon();
            break;
        case ClientCommand::block_upload:
            block_upload(request, now);
            break;
        case ClientCommand::block_download:
            block_download(request, now);
            break;
        case ClientCommand::unassigned:
        default:
            object_ = sdo::named_object(request);
            abort(AbortCode::command_specifier);
            break;
    }
}

static_assert(implements<req::CO_SDO_044>);
void SdoServer::send(const std::uint64_t bytes) noexcept {
    static_cast<void>(queue_.push(response_id_, max_frame_length, bytes));
}

void SdoServer::begin(const State state, const Instant now) noexcept {
    state_ = state;
    toggle_ = 0U;
    done_ = 0U;
    last_progress_ = now;
    idle_until_ = deadline();
}

static_assert(implements<req::CO_SDO_034>);
AbortCode SdoServer::open_download(const bool has_size, const std::uint32_t announced) noexcept {
    const auto place = objects_.writable(object_.index(), object_.subindex());
    if (!place.ok()) {
        return place.error();
    }
    const std::size_t capacity = place.value().capacity;
    static_assert(implements<req::CO_SDO_010>);
    if (has_size && (announced > capacity)) {
        return AbortCode::too_long;
    }
    const MutableBytes lent = place.value().staging;
    const MutableBytes memory = (lent.size() > 0U) ? lent : MutableBytes{buffer_};
    if (capacity > memory.size()) {
        return AbortCode::out_of_memory;
    }
    place_ = memory.part(0U, capacity);
    has_size_ = has_size;
    announced_ = announced;
    return AbortCode::none;
}

static_assert(implements<req::CO_SDO_060>);
static_assert(implements<req::CO_SDO_011>);
AbortCode SdoServer::commit(const std::size_t size, const Instant now) noexcept {
    if (has_size_ && (announced_ != size)) {
        return AbortCode::length_mismatch;
    }
    return objects_.write(object_.index(), object_.subindex(), place_.view().part(0U, size), now);
}

void SdoServer::initiate_download(const sdo::Request& request, const Instant now) noexcept {
    select(request);
    if ((request[0] & sdo::expedited_flag) != 0U) {
        download_expedited(request, now);
    } else {
        download_in_segments(request, now);
    }
}

void SdoServer::download_in_segments(const sdo::Request& request, const Instant now) noexcept {
    const AbortCode code = open_download((request[0] & sdo::size_flag) != 0U, sdo::announced_size(request));
    if (code != AbortCode::none) {
        abort(code);
        return;
    }
    begin(State::downloading, now);
    answer_object(sdo::download_done);
}

static_assert(implements<req::CO_SDO_003>);
std::size_t SdoServer::expedited_length(const std::uint8_t command) const noexcept {
    if ((command & sdo::size_flag) != 0U) {
        return sdo::expedited_capacity - ((std::uint32_t{command} >> 2U) & 0x03U);
    }
    // If the client gives no size, the length of the entry applies.
    const auto place = objects_.writable(object_.index(), object_.subindex());
    const bool shorter = place.ok() && (place.value().capacity < sdo::expedited_capacity);
    return shorter ? place.value().capacity : sdo::expedited_capacity;
}

void SdoServer::download_expedited(const sdo::Request& request, const Instant now) noexcept {
    const ByteView data = ByteView{request}.part(sdo::data_position, expedited_length(request[0]));
    const AbortCode code = objects_.write(object_.index(), object_.subindex(), data, now);
    if (code == AbortCode::none) {
        answer_object(sdo::download_done);
    } else {
        abort(code);
    }
}

static_assert(implements<req::CO_SDO_004>);
void SdoServer::download_segment(const sdo::Request& request, const Instant now) noexcept {
    if (state_ != State::downloading) {
        refuse_command();
        return;
    }
    const std::uint8_t command = request[0];
    if (!toggle_fits(command)) {
        return;
    }
    const ByteView data = ByteView{request}.part(1U, sdo::segment_capacity - ((std::uint32_t{command} >> 1U) & 0x07U));
    if ((done_ + data.size()) > place_.size()) {
        abort(AbortCode::too_long);
        return;
    }
    place_.copy(done_, data);
    done_ += data.size();
    last_progress_ = now;
    static_assert(implements<req::CO_SDO_043>);
    if ((command & sdo::last_segment_flag) != 0U) {
        const AbortCode code = commit(done_, now);
        if (code != AbortCode::none) {
            abort(code);
            return;
        }
        abandon();
    }
    send(sdo::download_segment_done | (command & sdo::toggle_bit));
}

ByteView SdoServer::keep(const ByteView value) noexcept {
    if (value.size() > buffer_size) {
        return value;
    }
    MutableBytes{buffer_}.copy(0U, value);
    return ByteView{buffer_.data(), value.size()};
}

static_assert(implements<req::CO_SDO_001> && implements<req::CO_SDO_002> && implements<req::CO_SDO_042>);
void SdoServer::initiate_upload(const sdo::Request& request, const Result<ByteView, AbortCode>& read,
                                const Instant now) noexcept {
    select(request);
    if (!read.ok()) {
        abort(read.error());
        return;
    }
    const std::size_t size = read.value().size();
    if ((size != 0U) && (size <= sdo::expedited_capacity)) {
        answer_object(sdo::expedited_upload(static_cast<std::uint32_t>(size)),
                      static_cast<std::uint32_t>(number_in(read.value())));
    } else {
        value_ = keep(read.value());
        begin(State::uploading, now);
        answer_object(sdo::upload_initiated | sdo::size_flag, static_cast<std::uint32_t>(size));
    }
}

static_assert(implements<req::CO_SDO_055>);
static_assert(implements<req::CO_SDO_019>);
void SdoServer::upload_segment(const sdo::Request& request, const Instant now) noexcept {
    const std::uint8_t command = request[0];
    if (!toggle_fits(command)) {
        return;
    }
    const ByteView rest{value_};
    if (rest.size() > sdo::segment_capacity) {
        value_ = rest.part(sdo::segment_capacity, rest.size() - sdo::segment_capacity);
        last_progress_ = now;
        send((sdo::read_segment(rest, 0U) << 8U) | (command & sdo::toggle_bit));
    } else {
        upload_last_segment(command & sdo::toggle_bit);
    }
}

void SdoServer::upload_last_segment(const std::uint32_t toggle) noexcept {
    const std::size_t unused = sdo::segment_capacity - value_.size();
    abandon();
    send((sdo::read_segment(value_, 0U) << 8U) | (unused << 1U) | toggle | sdo::last_segment_flag);
}

static_assert(implements<req::CO_SDO_018> && implements<req::CO_SDO_056>);
void SdoServer::refuse_command() noexcept {
    if (state_ == State::idle) {
        // No transfer is open and the request has no object: the abort must not contain the object of an earlier
        // transfer.
        object_ = sdo::NamedObject{};
    }
    abort(AbortCode::command_specifier);
}

static_assert(implements<req::CO_SDO_005>);
bool SdoServer::toggle_fits(const std::uint8_t command) noexcept {
    if ((command & sdo::toggle_bit) != toggle_) {
        abort(AbortCode::toggle_not_alternated);
        return false;
    }
    toggle_ = static_cast<std::uint8_t>(toggle_ ^ sdo::toggle_bit);
    return true;
}

static_assert(implements<req::CO_SDO_014>);
static_assert(implements<req::CO_SDO_037>);
void SdoServer::proceed(const Instant now) noexcept {
    send_segments(now);
    if (deadline() <= now) {
        abort(AbortCode::time_out);
    } else {
        idle_until_ = deadline();
    }
}
static_assert(implements<req::CO_SDO_036> && implements<req::CO_SDO_063>);
void SdoServer::abort(const AbortCode code) noexcept {
    abandon();
    answer_object(sdo::aborted, static_cast<std::uint32_t>(code));
}

}  // namespace canproof
