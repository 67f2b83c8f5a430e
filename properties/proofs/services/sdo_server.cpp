// SPDX-License-Identifier: Apache-2.0
// Theorems on the SDO server without block transfer: for any frame of a client, any state and any answer of the object
// dictionary.
#include "firmware/canopen/sdo_server.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/queue.hpp"
#include "properties/proofs/support/sdo.hpp"

namespace canproof::proofs {

namespace {

using State = SdoServer::State;

}  // namespace

void a_reset_sdo_server_is_consistent() {
    shows(
        "a new server that is reset has no transfer, serves no request, and is consistent; when it listens, it has the "
        "identifiers of its node-ID");
    AnyObjects objects{};
    TransmitQueue queue{};
    SdoServer server{objects, queue, false};
    const auto node_id = any<std::uint8_t>();
    server.reset(node_id);
    claim(server.is_consistent() && (server.state_ == State::idle));
    const Frame frame = any_frame();
    assume(frame.id <= 0x1FFFFFFFU);  // 29 bits
    claim(!server.is_request(frame));
    server.listen(true);
    claim((server.request_id_ == (0x600U + node_id)) && (server.response_id_ == (0x580U + node_id)));
}

void an_sdo_request_is_answered_at_most_once() {
    shows("any request in any state leaves the server consistent; it is answered at most once, with eight bytes");
    proves<req::CO_SDO_007, req::CO_FRAME_001>();
    Served node{};
    const Frame frame = any_request();
    receive(node, frame, any_time());
    claim(node.server.is_consistent());
    claim(node.queue.size() <= 1U);
    claim((frame.length == 8U) || (node.queue.empty() && (node.objects.writes_ == 0U)));
    claim(node.queue.empty() || ((waiting(node.queue, 0U).id == node.server.response_id_) &&
                                 (waiting(node.queue, 0U).length == 8U) && !waiting(node.queue, 0U).remote));
    const bool is_request = node.server.is_request(frame);
    claim(is_request == ((frame.id == node.server.request_id_) && !frame.extended && !frame.remote));
}

void an_sdo_write_is_confirmed_exactly_when_taken() {
    shows(
        "a request writes at most once; the server confirms what was taken, and answers what was refused with its "
        "abort code");
    proves<req::CO_SDO_004, req::CO_SDO_043, req::CO_SDO_011>();
    Served node{};
    const Frame frame = any_request();
    receive(node, frame, any_time());
    claim(node.objects.writes_ <= 1U);
    if (node.objects.writes_ == 1U) {
        const std::uint64_t answer = field_le<0U, 8U>(waiting(node.queue, 0U).data);
        claim(node.queue.size() == 1U);
        claim(node.has_aborted() != node.objects.is_taken_);
        claim(node.objects.is_taken_ || ((answer >> 32U) == static_cast<std::uint32_t>(node.objects.refusal_)));
        claim(node.server.state_ == State::idle);
    }
}

void a_number_is_uploaded_as_any_value_of_its_bytes() {
    shows(
        "the upload of any number of one to four bytes, in any state, is answered with its size, its object and its "
        "bytes, as that of a value with the same bytes is; no transfer is open afterwards");
    proves<req::CO_SDO_001, req::CO_SDO_012>();
    Served of_number{all_sdo_states};
    AnyObjects objects{};
    TransmitQueue queue{};
    SdoServer of_value{objects, queue, false};
    of_value.response_id_ = of_number.server.response_id_;
    const Frame request = any_frame();
    const std::uint32_t size = 1U + std::uint32_t{each(4U)};
    const auto bytes = any<std::array<std::uint8_t, 4U>>();
    const std::uint64_t number = field_le<0U, 4U>(bytes) & (0xFFFFFFFFU >> (32U - (8U * size)));
    of_number.server.upload_number(sdo::named_object(request.data), size, static_cast<std::uint32_t>(number));
    const auto read = Result<ByteView, AbortCode>::success(ByteView{bytes.data(), size});
    of_value.initiate_upload(request.data, read, any_time());
    claim((of_number.queue.size() == 1U) && (queue.size() == 1U));
    claim(is_same(waiting(of_number.queue, 0U), waiting(queue, 0U)));
    const std::uint64_t answer = field_le<0U, 8U>(waiting(queue, 0U).data);
    const std::uint64_t named = field_le<0U, 4U>(request.data) & 0xFFFFFF00U;
    claim(answer == ((number << 32U) | named | (0x43U + (4U * (4U - size)))));
    claim((of_number.server.state_ == State::idle) && (of_value.state_ == State::idle));
    claim(of_number.server.is_consistent() && of_value.is_consistent());
}

void an_sdo_upload_ends() {
    shows("a segment of an upload leaves fewer bytes to send, seven for each full segment, or ends the transfer");
    proves<req::CO_SDO_055>();
    Served node{};
    const std::size_t before = node.server.value_.size();
    const bool goes_up = node.server.state_ == State::uploading;
    const Frame frame = any_frame();
    assume((frame.length == 8U) && goes_up && ((std::uint32_t{frame.data[0]} >> 5U) == 3U));
    receive(node, frame, any_time());
    const bool goes_on = node.server.state_ == State::uploading;
    claim(!goes_on || ((before > 7U) && (node.server.value_.size() == (before - 7U))));
    claim(node.has_aborted() || (goes_on == (before > 7U)));
    claim(node.server.is_consistent());
}

void an_sdo_abort_ends_the_transfer() {
    shows("an abort of either side ends the transfer; the client's is not answered");
    proves<req::CO_SDO_013, req::CO_SDO_063>();
    Served node{};
    const Frame frame = any_request();
    assume(frame.length == 8U);
    receive(node, frame, any_time());
    const bool from_client = (frame.data[0] >> 5U) == 4U;
    claim(!from_client || (node.queue.empty() && (node.server.state_ == State::idle) && (node.objects.writes_ == 0U)));
    claim(from_client || node.queue.size() == 1U);
    claim(!node.has_aborted() || (node.server.state_ == State::idle));
}

void an_sdo_toggle_bit_alternates() {
    shows("a segment with the wrong toggle bit ends the transfer with 05030000h and writes nothing");
    proves<req::CO_SDO_005>();
    Served node{};
    const Frame frame = any_frame();
    const std::uint32_t command = frame.data[0];
    const bool goes_down = (node.server.state_ == State::downloading) && ((command >> 5U) == 0U);
    const bool goes_up = (node.server.state_ == State::uploading) && ((command >> 5U) == 3U);
    assume((frame.length == 8U) && (goes_down || goes_up) && ((command & 0x10U) != node.server.toggle_));
    receive(node, frame, any_time());
    claim(node.has_aborted() && (node.objects.writes_ == 0U));
    claim((field_le<0U, 8U>(waiting(node.queue, 0U).data) >> 32U) == 0x05030000U);
}

void a_stalled_sdo_transfer_ends_in_time() {
    shows("advance() aborts a transfer exactly when its time is over, with 05040000h, and leaves nothing overdue");
    proves<req::CO_SDO_014>();
    Served node{};
    const Instant now = any_time();
    assume(node.server.last_progress_.us < (std::uint64_t{1U} << 63U));
    const bool is_late = (node.server.state_ != State::idle) && (now.us >= (node.server.last_progress_.us + 1000000U));
    node.server.advance(now);
    claim(node.queue.size() == (is_late ? 1U : 0U));
    claim(!is_late || (node.has_aborted() && ((field_le<0U, 8U>(waiting(node.queue, 0U).data) >> 32U) == 0x05040000U)));
    claim(node.server.next_deadline() > now);
    claim(node.server.is_consistent());
}

}  // namespace canproof::proofs
