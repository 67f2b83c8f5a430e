// SPDX-License-Identifier: Apache-2.0
// Theorem on uploads from the dictionary: the node answers each upload as the SDO server answers the value that is
// read.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/any_node.hpp"
#include "properties/proofs/support/queue.hpp"

namespace canproof::proofs {

void an_upload_is_answered_with_what_is_read() {
    shows(
        "a request that begins an upload from any object of the CAN-CBX-AO412 and any sub-index, in any state of a "
        "node "
        "without PDOs and of its SDO server, gets the same answer as the SDO server gives to the value or the abort "
        "code "
        "that is read; it changes no byte of the image");
    proves<req::CO_SDO_001, req::CO_SDO_002, req::CO_SDO_008, req::CO_SDO_057, req::CO_SDO_058>();
    AnyNode any_node{};
    Node& node = any_node.node;
    const std::uint16_t index = generated::cbx_ao412::object_rows[each(generated::cbx_ao412::object_rows.size())].index;
    auto request = any<sdo::Request>();
    set_field_le<sdo::index_position, 2U>(request, index);
    const std::uint8_t subindex = request[sdo::subindex_position];
    const std::size_t at = any<std::size_t>();
    assume(at < generated::cbx_ao412::image_size);
    const std::uint8_t before = any_node.dictionary.image[at];
    const Instant now = any_time();
    TransmitQueue queue{};
    SdoServer server{node, queue, false};
    server.response_id_ = node.sdo_.response_id_;
    server.initiate_upload(request, node.read(index, subindex), now);
    node.serve_upload(request, now);
    claim((any_node.queue.size() == 1U) && (queue.size() == 1U));
    claim(is_same(waiting(any_node.queue, 0U), waiting(queue, 0U)));
    claim((node.sdo_.state_ == server.state_) && (node.sdo_.idle_until_ == server.idle_until_));
    claim(any_node.dictionary.image[at] == before);
}

}  // namespace canproof::proofs
