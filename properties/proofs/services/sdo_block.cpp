// SPDX-License-Identifier: Apache-2.0
// Theorems on SDO block transfer: for any frame of a client, any state of a server that offers block transfer, and any
// answer of the object dictionary.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/sdo.hpp"

namespace canproof::proofs {

namespace {

using State = SdoServer::State;

constexpr bool offers_block = true;
constexpr SdoStates downloading{static_cast<std::size_t>(State::block_downloading), 1U};
/// the end of a block download, and all states of a block upload
constexpr SdoStates others{static_cast<std::size_t>(State::block_download_ending), 4U};
constexpr SdoStates starting{static_cast<std::size_t>(State::block_upload_starting), 1U};
constexpr SdoStates uploading{static_cast<std::size_t>(State::block_uploading), 1U};

constexpr std::size_t most = generated::canopen::sdo_block_queued;  ///< most segments queued at once

/// Splits the theorem about an upload into cases, one for each pair of two numbers. The first is `left`, the segments
/// left in the sub-block. The second is the number of full segments that the value has from byte `from` on. For both,
/// all numbers from `most` on are one case.
void split(const Served& node, const std::size_t left, const std::size_t from) {
    const std::size_t more = each(most + 1U);
    const std::size_t full = each(most + 1U);
    const std::size_t rest = node.server.value_.size() - from;
    assume((more == most) ? (left >= most) : (left == more));
    assume((full == 0U) || (rest > (full * sdo::segment_capacity)));
    assume((full == most) || (rest <= ((full + 1U) * sdo::segment_capacity)));
}

/// Returns any request of a block upload (A0h in byte 0) whose two lowest bits in byte 0 are `command`.
Frame block_upload_request(const sdo::BlockUploadCommand command) {
    Frame frame = any_frame();
    frame.length = max_frame_length;
    frame.data[0] =
        static_cast<std::uint8_t>((std::uint32_t{frame.data[0]} & 0x1CU) | 0xA0U | static_cast<std::uint32_t>(command));
    return frame;
}

}  // namespace

void a_block_download_segment_keeps_the_server_consistent() {
    shows(
        "any frame during a block download leaves the server consistent; it is answered at most once, writes nothing");
    proves<req::CO_SDO_030, req::CO_SDO_026, req::CO_SDO_027>();
    Served node{downloading, offers_block};
    const Frame frame = any_frame();
    const std::size_t before = node.server.received_.size_;
    const std::uint32_t sequence = frame.data[0] & 0x7FU;
    const bool is_next = sequence == (node.server.received_.in_order_ + 1U);
    node.server.receive(frame, any_time());
    claim(is_consistent(node.server));
    claim((node.queue.size() <= 1U) && (node.objects.writes_ == 0U));
    claim(is_next || (node.server.received_.size_ == before));
    const bool is_invalid = (frame.length == 8U) && (sequence == 0U) && (frame.data[0] != 0x80U);
    claim(!is_invalid || (node.has_aborted() && (node.server.state_ == State::idle)));
}

void a_request_behind_the_segments_keeps_the_server_consistent() {
    shows(
        "any request behind the segments of a block transfer, except the start and the acknowledgement of an upload, "
        "leaves the server consistent, is answered at most once and writes at most once");
    proves<req::CO_SDO_020, req::CO_SDO_052>();
    Served node{others, offers_block};
    const Frame frame = any_request();
    const std::uint32_t command = frame.data[0] & 0x03U;
    assume(((frame.data[0] >> 5U) != 5U) || (command == 0U) || (command == 1U));
    node.server.receive(frame, any_time());
    claim(is_consistent(node.server));
    claim((node.queue.size() <= 1U) && (node.objects.writes_ <= 1U));
}

void the_start_of_a_block_upload_keeps_the_server_consistent() {
    shows("the start of a block upload leaves the server consistent and queues at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_053>();
    Served node{starting, offers_block};
    const SdoBlockUpload& sent = node.server.sent_;
    split(node, std::size_t{sent.block_size_} - sent.sent_,
          sent.base_ + (std::size_t{sent.sent_} * sdo::segment_capacity));
    node.server.receive(block_upload_request(sdo::BlockUploadCommand::start), any_time());
    claim(is_consistent(node.server));
    claim((node.queue.size() <= most) && (node.objects.writes_ == 0U));
}

void an_acknowledgement_keeps_the_server_consistent() {
    shows("any acknowledgement of a sub-block leaves the server consistent and queues at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_022, req::CO_SDO_025, req::CO_SDO_053>();
    Served node{uploading, offers_block};
    const Frame frame = block_upload_request(sdo::BlockUploadCommand::acknowledge);
    split(node, frame.data[2], node.server.sent_.base_ + (std::size_t{frame.data[1]} * sdo::segment_capacity));
    node.server.receive(frame, any_time());
    claim(is_consistent(node.server));
    claim((node.queue.size() <= most) && (node.objects.writes_ == 0U));
}

void a_block_transfer_begins_consistent() {
    shows(
        "any request to a server that offers block transfer, with no transfer or another one open, leaves it "
        "consistent "
        "and is answered at most once");
    proves<req::CO_SDO_029, req::CO_SDO_031>();
    Served node{states_without_block, offers_block};
    const Frame frame = any_request();
    node.server.receive(frame, any_time());
    claim(is_consistent(node.server));
    claim((node.queue.size() <= 1U) && (node.objects.writes_ <= 1U));
}

void a_stalled_block_transfer_ends_in_time() {
    shows("advance() keeps a block transfer in which no segments leave consistent and queues at most one frame");
    proves<req::CO_SDO_014>();
    Served node{others, offers_block};
    assume(!node.server.can_send_segment());
    node.server.advance(any_time());
    claim(is_consistent(node.server));
    claim(node.queue.size() <= 1U);
}

void segments_that_leave_keep_the_server_consistent() {
    shows("advance() keeps a block upload whose segments leave consistent and queues at most 8 frames");
    proves<req::CO_SDO_014, req::CO_SDO_053>();
    Served node{uploading, offers_block};
    const SdoBlockUpload& sent = node.server.sent_;
    assume(node.server.can_send_segment());
    split(node, std::size_t{sent.block_size_} - sent.sent_,
          sent.base_ + (std::size_t{sent.sent_} * sdo::segment_capacity));
    node.server.advance(any_time());
    claim(is_consistent(node.server));
    claim(node.queue.size() <= most);
}

}  // namespace canproof::proofs
