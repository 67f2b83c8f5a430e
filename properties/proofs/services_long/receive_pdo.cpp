// SPDX-License-Identifier: Apache-2.0
// Theorem on PDO reception whose proof takes minutes: for any frame and for two receive PDOs in any state.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/receive_pdos.hpp"

namespace canproof::proofs {

void an_rpdo_is_taken_whole_or_not_at_all() {
    shows(
        "any frame in operational leaves two RPDOs of up to two entries consistent; a frame that is too short, is "
        "refused, waits for a SYNC or belongs to no RPDO changes no byte of the image, and no frame changes a byte "
        "that its RPDOs do not map");
    proves<req::CO_PDO_001, req::CO_PDO_004, req::CO_PDO_005, req::CO_PDO_059>();
    Receiving node{};
    const Frame frame = any_frame();
    const std::size_t at = any<std::size_t>();
    assume(at < image_size);
    const std::uint8_t before = node.image[at];
    bool may_change{false};
    for (std::size_t number = 0U; number < pdo_count; ++number) {
        const ReceivePdo& pdo = node.pdos[number];
        const bool is_short = frame.length < pdo.mapping.length();
        const bool waits = pdo.parameters.applied == PdoApplied::at_sync;
        may_change = may_change || ((pdo.identifier == frame.id) && !is_short && !waits && node.maps(number, at));
    }
    node.received.receive(frame, any_time());
    claim(node.received.is_consistent());
    claim(may_change || (node.image[at] == before));
    claim(node.queue.empty());
}

}  // namespace canproof::proofs
