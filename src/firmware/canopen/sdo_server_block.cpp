// SPDX-License-Identifier: Apache-2.0
// The requests of SDO block transfer (CiA 301, 7.2.4.3.8 to 7.2.4.3.16).
#include "firmware/canopen/sdo_protocol.hpp"
#include "firmware/canopen/sdo_server.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

using generated::canopen::sdo_block_size;
using sdo::BlockUploadCommand;

// Fields of block requests other than index and sub-index.
constexpr std::size_t block_size_position = 4U;
constexpr std::size_t switch_threshold_position = 5U;
constexpr std::size_t crc_position = 1U;
constexpr std::size_t sequence_position = 1U;
constexpr std::size_t next_block_size_position = 2U;

}  // namespace

void SdoServer::block_download(const sdo::Request& request, const Instant now) noexcept {
    const bool ends = (request[0] & sdo::block_end_flag) != 0U;
    if (ends) {
        end_block_download(request, now);
        return;
    }
    select(request);
    if (offers_block_) {
        initiate_block_download(request, now);
    } else {
        abort(AbortCode::command_specifier);
    }
}

static_assert(implements<req::CO_SDO_029>);
void SdoServer::initiate_block_download(const sdo::Request& request, const Instant now) noexcept {
    const std::uint8_t command = request[0];
    const AbortCode code = open_download((command & sdo::block_size_flag) != 0U, sdo::announced_size(request));
    if (code != AbortCode::none) {
        abort(code);
        return;
    }
    received_.start(place_, (command & sdo::block_crc_flag) != 0U);
    begin(State::block_downloading, now);
    answer_object(sdo::block_download_initiated | sdo::block_crc_flag, sdo_block_size);
}

static_assert(implements<req::CO_SDO_030>);
void SdoServer::block_download_segment(const sdo::Request& request, const Instant now) noexcept {
    last_progress_ = now;
    const SdoBlockDownload::Step step = received_.take(request);
    if (step == SdoBlockDownload::Step::none) {
        return;
    }
    switch (step) {
        case SdoBlockDownload::Step::acknowledge:
            send(sdo::block_acknowledged | (std::uint32_t{received_.acknowledge()} << 8U) |
                 (std::uint32_t{sdo_block_size} << 16U));
            state_ = received_.complete() ? State::block_download_ending : State::block_downloading;
            break;
        case SdoBlockDownload::Step::invalid_sequence:
            if (request[0] == sdo::aborted) {
                abandon();
            } else {
                abort(AbortCode::invalid_sequence_number);
            }
            break;
        case SdoBlockDownload::Step::too_long:
            abort(AbortCode::too_long);
            break;
        case SdoBlockDownload::Step::none:
        default:
            break;
    }
}

static_assert(implements<req::CO_SDO_052>);
void SdoServer::end_block_download(const sdo::Request& request, const Instant now) noexcept {
    if (state_ != State::block_download_ending) {
        refuse_command();
        return;
    }
    const auto unused = static_cast<std::uint8_t>((std::uint32_t{request[0]} >> 2U) & 0x07U);
    AbortCode code = received_.finish(unused, static_cast<std::uint16_t>(field_le<crc_position, 2U>(request)));
    if (code == AbortCode::none) {
        code = commit(received_.size(), now);
    }
    if (code == AbortCode::none) {
        abandon();
        send(sdo::block_download_done);
    } else {
        abort(code);
    }
}

void SdoServer::block_upload(const sdo::Request& request, const Instant now) noexcept {
    switch (static_cast<BlockUploadCommand>(request[0] & 0x03U)) {
        case BlockUploadCommand::initiate:
            select(request);
            if (offers_block_) {
                initiate_block_upload(request, now);
            } else {
                abort(AbortCode::command_specifier);
            }
            break;
        case BlockUploadCommand::start:
            if (state_ == State::block_upload_starting) {
                begin(State::block_uploading, now);
                send_segments(now);
            } else {
                refuse_command();
            }
            break;
        case BlockUploadCommand::acknowledge:
            acknowledge_block_upload(request, now);
            break;
        case BlockUploadCommand::end:
        default:
            static_assert(implements<req::CO_SDO_049>);
            if (state_ == State::block_upload_ending) {
                abandon();
            } else {
                refuse_command();
            }
            break;
    }
}

static_assert(implements<req::CO_SDO_020>);
static_assert(implements<req::CO_SDO_031>);
void SdoServer::initiate_block_upload(const sdo::Request& request, const Instant now) noexcept {
    const auto read = objects_.read(object_.index(), object_.subindex());
    if (!read.ok()) {
        abort(read.error());
        return;
    }
    const std::uint8_t block_size = request[block_size_position];
    if (!SdoBlockUpload::is_block_size(block_size)) {
        abort(AbortCode::invalid_block_size);
        return;
    }
    const std::uint8_t threshold = request[switch_threshold_position];
    if ((threshold != 0U) && (read.value().size() <= threshold)) {
        initiate_upload(request, read, now);
        return;
    }
    value_ = keep(read.value());
    sent_.start(value_, block_size, (request[0] & sdo::block_crc_flag) != 0U);
    begin(State::block_upload_starting, now);
    answer_object(sdo::block_upload_initiated | sdo::block_crc_flag | sdo::block_size_flag,
                  static_cast<std::uint32_t>(value_.size()));
}

static_assert(implements<req::CO_SDO_025>);
void SdoServer::acknowledge_block_upload(const sdo::Request& request, const Instant now) noexcept {
    if (state_ != State::block_uploading) {
        refuse_command();
        return;
    }
    const AbortCode code = sent_.acknowledge(request[sequence_position], request[next_block_size_position]);
    if (code != AbortCode::none) {
        abort(code);
        return;
    }
    last_progress_ = now;
    if (!sent_.complete()) {
        send_segments(now);
        return;
    }
    send(sdo::block_upload_ended | (std::uint32_t{sent_.unused()} << 2U) | (std::uint32_t{sent_.crc()} << 8U));
    state_ = State::block_upload_ending;
}

static_assert(implements<req::CO_SDO_021>);
static_assert(implements<req::CO_SDO_039>);
void SdoServer::send_segments(const Instant now) noexcept {
    if (!can_send_segment()) {
        return;
    }
    static_assert(implements<req::CO_SDO_053>);
    last_progress_ = now;
    sent_.send(queue_, response_id_);
}

}  // namespace canproof
