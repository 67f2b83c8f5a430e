// SPDX-License-Identifier: Apache-2.0
// Theorems on SDO block transfer: for any frame of a client, any state of a server that offers block transfer, and any
// answer of the object dictionary.
#include "properties/proofs/support/sdo_block.hpp"

#include "generated/canopen/requirements.hpp"

namespace canproof::proofs {

void a_block_download_segment_keeps_the_server_consistent() {
    shows(
        "any frame during a block download leaves the server consistent; it is answered at most once, writes nothing");
    proves<req::CO_SDO_030, req::CO_SDO_026, req::CO_SDO_027>();
    Served node{downloading, offers_block};
    const Frame frame = any_frame();
    const std::size_t before = node.server.received_.size_;
    const std::uint32_t sequence = frame.data[0] & 0x7FU;
    const bool is_next = sequence == (node.server.received_.in_order_ + 1U);
    receive(node, frame, any_time());
    claim(node.server.is_consistent());
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
    receive(node, frame, any_time());
    claim(node.server.is_consistent());
    claim((node.queue.size() <= 1U) && (node.objects.writes_ <= 1U));
}

void a_block_transfer_begins_consistent() {
    shows(
        "any request to a server that offers block transfer, with no transfer or another one open, leaves it "
        "consistent "
        "and is answered at most once");
    proves<req::CO_SDO_029, req::CO_SDO_031>();
    Served node{states_without_block, offers_block};
    const Frame frame = any_request();
    receive(node, frame, any_time());
    claim(node.server.is_consistent());
    claim((node.queue.size() <= 1U) && (node.objects.writes_ <= 1U));
}

void a_stalled_block_transfer_ends_in_time() {
    shows("advance() keeps a block transfer in which no segments leave consistent and queues at most one frame");
    proves<req::CO_SDO_014>();
    Served node{others, offers_block};
    assume(!node.server.can_send_segment());
    node.server.advance(any_time());
    claim(node.server.is_consistent());
    claim(node.queue.size() <= 1U);
}

}  // namespace canproof::proofs
