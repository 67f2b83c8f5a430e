// SPDX-License-Identifier: Apache-2.0
// Theorems on PDO reception: for any frame and for two receive PDOs in any state. Each PDO maps up to two entries. The
// dictionary has any rows; a value has one of two limits or none.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/receive_pdos.hpp"

namespace canproof::proofs {

void a_refused_rpdo_changes_no_byte() {
    shows("an RPDO with a value that its owner refuses changes no byte of the image and is noticed as refused");
    proves<req::CO_PDO_005, req::CO_PDO_034>();
    Receiving node{};
    const Frame frame = any_frame();
    ReceivePdo& pdo = node.pdos[0U];
    assume((pdo.identifier == frame.id) && (node.pdos[1U].identifier != frame.id));
    assume((pdo.mapping.lines_.size() == 2U) && (frame.length >= pdo.mapping.length()));
    assume((node.lines[0U].row != nullptr) && (node.rows[0U].service != Service::none));
    assume(!node.owner.takes_);
    const std::size_t at = any<std::size_t>();
    assume(at < image_size);
    const std::uint8_t before = node.image[at];
    node.received.receive(frame, any_time());
    claim(node.image[at] == before);
    claim(node.received.has_refused() && (node.owner.effects_ == 0U));
}

void a_short_rpdo_is_noticed() {
    shows("an RPDO with fewer bytes than its mapping raises its error, and has no effect");
    proves<req::CO_PDO_004, req::CO_PDO_020>();
    Receiving node{};
    const Frame frame = any_frame();
    const ReceivePdo& pdo = node.pdos[0U];
    assume((pdo.identifier == frame.id) && (frame.length < pdo.mapping.length()));
    assume(node.pdos[1U].identifier != frame.id);
    const bool waited = pdo.waits;
    const Instant due = pdo.due;
    node.received.receive(frame, any_time());
    claim(node.received.has_short());
    claim((pdo.waits == waited) && (pdo.due == due));
    claim(node.owner.effects_ == 0U);
}

void a_sync_applies_what_waits() {
    shows("after a SYNC no RPDO waits, and without one that waited no byte of the image changes");
    proves<req::CO_PDO_002>();
    Receiving node{};
    const bool waited = node.pdos[0U].waits || node.pdos[1U].waits;
    const std::size_t at = any<std::size_t>();
    assume(at < image_size);
    const std::uint8_t before = node.image[at];
    node.received.sync(any_time());
    claim(!node.pdos[0U].waits && !node.pdos[1U].waits);
    claim(waited || (node.image[at] == before));
    claim(node.received.is_consistent());
}

void an_overdue_rpdo_is_noticed_in_time() {
    shows("advance() notices each RPDO that is overdue, and nothing that is due is left");
    proves<req::CO_PDO_021>();
    Receiving node{};
    const Instant now = any_time();
    const bool is_late = node.pdos[0U].due <= now;
    const std::uint32_t before = node.received.overdue();
    node.received.advance(now);
    claim(now < node.received.next_deadline());
    claim((node.received.overdue() & 1U) == ((before & 1U) | (is_late ? 1U : 0U)));
    claim(node.received.is_consistent());
}

void nothing_waits_outside_operational() {
    shows("stop() leaves no RPDO that waits or is due");
    proves<req::CO_PDO_036>();
    Receiving node{};
    node.received.stop();
    claim(!node.pdos[0U].waits && !node.pdos[1U].waits);
    claim(node.received.next_deadline() == never);
    claim(node.received.is_consistent());
}

void a_remote_frame_reads_an_rpdo_at_most_once() {
    shows("a remote frame gets at most one answer of each RPDO, with the identifier and length of that RPDO");
    proves<req::CO_PDO_062, req::CO_PDO_063>();
    Receiving node{};
    const Frame request = any_frame();
    node.received.answer(request);
    const bool is_alone = node.pdos[1U].identifier != request.id;
    claim(node.queue.size() <= (is_alone ? 1U : 2U));
    if (!node.queue.empty()) {
        claim((waiting(node.queue, 0U).id == request.id) && !request.extended);
        claim(!is_alone || (waiting(node.queue, 0U).length == node.pdos[0U].mapping.length()));
    }
}

}  // namespace canproof::proofs
