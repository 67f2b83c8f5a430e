// SPDX-License-Identifier: Apache-2.0
// Theorems on the segments of a block upload, whose proofs take minutes: for any request of a client, any state of a
// server that offers block transfer, and any value.
#include "properties/proofs/support/sdo_block.hpp"

#include "generated/canopen/requirements.hpp"

namespace canproof::proofs {

void the_start_of_a_block_upload_keeps_the_server_consistent() {
    shows("the start of a block upload leaves the server consistent and queues at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_053>();
    Served node{starting, offers_block};
    const SdoBlockUpload& sent = node.server.sent_;
    split(node, std::size_t{sent.block_size_} - sent.sent_,
          sent.base_ + (std::size_t{sent.sent_} * sdo::segment_capacity));
    node.server.receive(block_upload_request(sdo::BlockUploadCommand::start), any_time());
    claim(node.server.is_consistent());
    claim((node.queue.size() <= most) && (node.objects.writes_ == 0U));
}

void an_acknowledgement_keeps_the_server_consistent() {
    shows("any acknowledgement of a sub-block leaves the server consistent and queues at most 8 frames");
    proves<req::CO_SDO_021, req::CO_SDO_022, req::CO_SDO_025, req::CO_SDO_053>();
    Served node{uploading, offers_block};
    const Frame frame = block_upload_request(sdo::BlockUploadCommand::acknowledge);
    split(node, frame.data[2], node.server.sent_.base_ + (std::size_t{frame.data[1]} * sdo::segment_capacity));
    node.server.receive(frame, any_time());
    claim(node.server.is_consistent());
    claim((node.queue.size() <= most) && (node.objects.writes_ == 0U));
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
    claim(node.server.is_consistent());
    claim(node.queue.size() <= most);
}

}  // namespace canproof::proofs
