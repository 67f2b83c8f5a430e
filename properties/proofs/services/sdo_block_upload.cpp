// SPDX-License-Identifier: Apache-2.0
// Theorems on the segments of a block upload: for any request of a client, any state of a server that offers block
// transfer, and any value.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/contract.hpp"
#include "properties/proofs/support/sdo_block.hpp"

namespace canproof::proofs {

namespace {

/// Contract of Crc16::add_segment() and Crc16::add(): the CRC has any value.
void segment_by_contract(Crc16& crc, const std::uint64_t /*frame*/) noexcept {
    leave_open(crc);
}
void bytes_by_contract(Crc16& crc, const ByteView /*bytes*/) noexcept {
    leave_open(crc);
}
/// Contract of get_le<8>(): it returns any number.
std::uint64_t number_by_contract(const ByteView /*bytes*/, const std::size_t /*at*/) noexcept {
    return any<std::uint64_t>();
}

/// Contract of SdoBlockUpload::send(): the upload stays consistent, and the queue has at most eight frames.
void send_by_contract(SdoBlockUpload& upload, TransmitQueue& queue, const std::uint32_t /*id*/) noexcept {
    claim(upload.is_consistent(upload.value_) && upload.can_send(0U));
    claim((queue.first_ == 0U) && (queue.end_ == 0U) && queue.open_ && !queue.boot_up_waits_);
    leave_open(queue.frames_);
    leave_open(queue.end_);
    leave_open(upload.sent_);
    leave_open(upload.last_sent_);
    leave_open(upload.unchecked_);
    leave_open(upload.crc_);
    assume(upload.is_consistent(upload.value_) && queue.is_bounded() && (queue.size() <= most));
}
/// Returns any number of bytes that are left of a value and that have `full` full segments before the last one. From
/// `most` on, all numbers are one case; `most` + 1 stands for no bytes.
std::size_t any_rest(const std::size_t full) {
    const std::size_t in_last = any<std::uint8_t>() & 7U;
    assume(in_last != 0U);
    const std::size_t more = (full == most) ? any<std::uint32_t>() : std::size_t{0U};
    return (full > most) ? 0U : ((full * sdo::segment_capacity) + in_last + more);
}

void use_contract_of_send() {
    use_contract("SdoBlockUpload::send", "segments_are_queued_up_to_the_end_of_the_value", send_by_contract);
}

}  // namespace

void segments_are_queued_up_to_the_end_of_the_value() {
    shows("the segments of a block upload that are sent at once leave it consistent and queue at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_053>();
    TransmitQueue queue{};
    SdoBlockUpload upload{};
    leave_open(upload);
    const std::size_t sent = upload.sent_;
    upload.base_ = any<std::uint32_t>();
    const std::size_t full = each(most + 2U);
    const std::size_t rest = any_rest(full);
    const std::size_t size = upload.base_ + (sent * sdo::segment_capacity) + rest;
    assume(size <= most_memory);
    const ByteView value{any_memory(size), size};
    upload.value_ = value;
    // The number of segments left in the sub-block; from the number of segments that are sent at once on, one case.
    const std::size_t at_once = (full > most) ? 1U : ((full < most) ? (full + 1U) : most);
    const std::size_t more = each(at_once) + std::size_t{1U};
    const std::size_t left = std::size_t{upload.block_size_} - sent;
    assume((more == at_once) ? (left >= more) : (left == more));
    assume(upload.is_consistent(value));
    assume(upload.can_send(queue.size()));
    use_contract("Crc16::add_segment", "crc16_takes_bytes_in_a_state_of_any_bits", segment_by_contract);
    use_contract("Crc16::add", "crc16_takes_bytes_in_a_state_of_any_bits", bytes_by_contract);
    use_contract("get_le<8ul>", "get_le_reads_8_bytes", number_by_contract);
    const Before upload_before{upload};
    const Before queue_before{queue};
    upload.send(queue, any<std::uint32_t>());
    claim(upload_before.holds_except(upload.sent_, upload.last_sent_, upload.unchecked_, upload.crc_));
    claim(queue_before.holds_except(queue.frames_, queue.end_));
    claim(upload.is_consistent(value));
    claim(queue.is_bounded() && (queue.size() <= most));
    claim(upload.sent_ > sent);
}

void the_start_of_a_block_upload_keeps_the_server_consistent() {
    shows("the start of a block upload leaves the server consistent and queues at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_053>();
    Served node{starting, offers_block};
    use_contract_of_send();
    receive(node, block_upload_request(sdo::BlockUploadCommand::start), any_time());
    claim(node.server.is_consistent());
    claim((node.queue.size() <= most) && (node.objects.writes_ == 0U));
}

void an_acknowledgement_keeps_the_server_consistent() {
    shows("any acknowledgement of a sub-block leaves the server consistent and queues at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_022, req::CO_SDO_025, req::CO_SDO_053>();
    Served node{uploading, offers_block};
    use_contract_of_send();
    receive(node, block_upload_request(sdo::BlockUploadCommand::acknowledge), any_time());
    claim(node.server.is_consistent());
    claim((node.queue.size() <= most) && (node.objects.writes_ == 0U));
}

void segments_that_leave_keep_the_server_consistent() {
    shows("advance() keeps a block upload whose segments leave consistent and queues at most 8 frames");
    proves<req::CO_SDO_014, req::CO_SDO_053>();
    Served node{uploading, offers_block};
    use_contract_of_send();
    assume(node.server.can_send_segment());
    node.server.advance(any_time());
    claim(node.server.is_consistent());
    claim(node.queue.size() <= most);
}

}  // namespace canproof::proofs
