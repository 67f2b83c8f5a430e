// SPDX-License-Identifier: Apache-2.0
// Theorems on the SDO server without block transfer: any frame of a client in any state, whatever the objects answer.
#include "firmware/canopen/sdo_server.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

using State = SdoServer::State;

/// Objects that may return anything that their interface allows. The choice is open, and is made before the call.
class AnyObjects final : public ObjectAccess {
  public:
    AnyObjects() {
        const std::size_t value_size = any_size();
        value_ = ByteView{any_memory(value_size), value_size};
        const std::size_t staging_size = any_size();
        staging_ = MutableBytes{any_memory(staging_size), staging_size};
        assume(refusal_ != AbortCode::none);
    }
    Result<ByteView, AbortCode> read(std::uint16_t /*index*/, std::uint8_t /*subindex*/) override {
        using Answer = Result<ByteView, AbortCode>;
        return is_readable_ ? Answer::success(value_) : Answer::failure(refusal_);
    }
    AbortCode write(std::uint16_t /*index*/, std::uint8_t /*subindex*/, ByteView value, Instant /*now*/) override {
        ++writes_;
        written_ = value.size();
        return is_taken_ ? AbortCode::none : refusal_;
    }
    Result<WritePlace, AbortCode> writable(std::uint16_t /*index*/, std::uint8_t /*subindex*/) override {
        using Answer = Result<WritePlace, AbortCode>;
        const WritePlace place{capacity_, lends_ ? staging_ : MutableBytes{}};
        return is_writable_ ? Answer::success(place) : Answer::failure(refusal_);
    }
    AbortCode before_received(const EntryRef& /*entry*/, std::uint64_t /*bits*/) override { return AbortCode::none; }
    void after_put(const EntryRef& /*entry*/, bool /*changes*/, Instant /*now*/) override {}

    ByteView value_{};
    MutableBytes staging_{};
    std::size_t capacity_{any_size()};
    AbortCode refusal_{any<AbortCode>()};
    bool is_readable_{any<bool>()};
    bool is_writable_{any<bool>()};
    bool is_taken_{any<bool>()};
    bool lends_{any<bool>()};
    std::size_t writes_{0U};
    std::size_t written_{0U};
};

/// Invariant between two requests, without block transfer: a transfer is at a place within its value, and its toggle
/// bit is 0 or 10h. Without a transfer no time is due. The stored object leaves room for the command of an answer
/// beside index and sub-index.
bool is_consistent(const SdoServer& server) {
    const bool is_idle = server.state_ == State::idle;
    const bool goes_down = server.state_ == State::downloading;
    const bool goes_up = server.state_ == State::uploading;
    return (is_idle || goes_down || goes_up) && ((server.toggle_ == 0U) || (server.toggle_ == 0x10U)) &&
           (!goes_down || (server.done_ <= server.place_.size())) &&
           (!goes_up || (server.done_ <= server.value_.size())) && (!is_idle || (server.idle_until() == never)) &&
           ((server.object_.bits & 0xFFU) == 0U);
}

/// Returns any frame. The theorem is decided for each command.
Frame any_request() {
    Frame frame = any_frame();
    const std::uint32_t rest = std::uint32_t{frame.data[0]} >> 3U;
    frame.data[0] = static_cast<std::uint8_t>((std::uint32_t{each(8U)} << 5U) | rest);
    return frame;
}

/// A server in any state without block transfer: decided for each state, and for a transfer in the server's own copy
/// and in memory of the object.
struct Served {
    AnyObjects objects{};
    TransmitQueue queue{};
    SdoServer server{objects, queue, false};

    Served() {
        leave_open(server);
        server.offers_block_ = false;
        server.state_ = static_cast<State>(each(3U));
        const std::size_t size = any_size();
        const bool is_copy = each(2U) == 1U;
        assume(size <= (is_copy ? SdoServer::buffer_size : objects.staging_.size()));
        server.place_ = is_copy ? MutableBytes{server.buffer_.data(), size} : objects.staging_.part(0U, size);
        const std::size_t length = any_size();
        assume(length <= (is_copy ? SdoServer::buffer_size : objects.value_.size()));
        server.value_ = is_copy ? ByteView{server.buffer_.data(), length} : objects.value_.part(0U, length);
        assume(is_consistent(server));
    }
    bool has_aborted() const { return !queue.empty() && (waiting(queue, 0U).data[0] == 0x80U); }
};

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
    claim(is_consistent(server) && (server.state_ == State::idle));
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
    node.server.receive(frame, any_time());
    claim(is_consistent(node.server));
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
    node.server.receive(frame, any_time());
    claim(node.objects.writes_ <= 1U);
    if (node.objects.writes_ == 1U) {
        const std::uint64_t answer = field_le<0U, 8U>(waiting(node.queue, 0U).data);
        claim(node.queue.size() == 1U);
        claim(node.has_aborted() != node.objects.is_taken_);
        claim(node.objects.is_taken_ || ((answer >> 32U) == static_cast<std::uint32_t>(node.objects.refusal_)));
        claim(node.server.state_ == State::idle);
    }
}

void an_sdo_abort_ends_the_transfer() {
    shows("an abort of either side ends the transfer; the client's is not answered");
    proves<req::CO_SDO_013, req::CO_SDO_042>();
    Served node{};
    const Frame frame = any_request();
    assume(frame.length == 8U);
    node.server.receive(frame, any_time());
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
    node.server.receive(frame, any_time());
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
    claim(is_consistent(node.server));
}

}  // namespace canproof::proofs
