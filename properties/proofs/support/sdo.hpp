// SPDX-License-Identifier: Apache-2.0
// An SDO server in any consistent state, and an object dictionary that may give any answer.
#pragma once

#include "firmware/canopen/sdo_server.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

/// An object dictionary that may return anything that its interface allows. The prover considers every answer. The
/// harness fixes the answer before the call of the firmware.
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
    bool is_watched(std::uint64_t /*marks*/) const override { return true; }

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

/// A range of states of the SDO server: `count` states, beginning with state number `first`.
struct SdoStates {
    std::size_t first;
    std::size_t count;
};
constexpr SdoStates states_without_block{0U, 3U};
constexpr SdoStates all_sdo_states{0U, 8U};

/// A server in one of the given states. The prover proves the theorem for each of these states, both with the value in
/// the server's own buffer and with the value in memory that the object provides.
struct Served {
    AnyObjects objects{};
    TransmitQueue queue{};
    SdoServer server{objects, queue, false};

    explicit Served(const SdoStates& states = states_without_block, const bool offers_block = false) {
        leave_open(server);
        server.offers_block_ = offers_block;
        server.state_ = static_cast<SdoServer::State>(states.first + each(states.count));
        const std::size_t size = any_size();
        const bool is_copy = each(2U) == 1U;
        assume(size <= (is_copy ? SdoServer::buffer_size : objects.staging_.size()));
        server.place_ = is_copy ? MutableBytes{server.buffer_.data(), size} : objects.staging_.part(0U, size);
        const std::size_t length = any_size();
        assume(length <= (is_copy ? SdoServer::buffer_size : objects.value_.size()));
        server.value_ = is_copy ? ByteView{server.buffer_.data(), length} : objects.value_.part(0U, length);
        server.received_.place_ = server.place_;
        server.sent_.value_ = server.value_;
        assume(server.is_consistent());
    }
    bool has_aborted() const { return !queue.empty() && (waiting(queue, 0U).data[0] == 0x80U); }
};

/// Gives a request to the server, as Node::serve_sdo() does. The node reads the value of an upload; here, `objects`
/// gives it.
inline void receive(Served& node, const Frame& request, const Instant now) {
    const sdo::ClientCommand command = sdo::command_of(request.data);
    if (node.server.receive_segment(request, now)) {
        return;
    }
    if (command == sdo::ClientCommand::initiate_download) {
        node.server.initiate_download(request.data, now);
    } else if (command == sdo::ClientCommand::initiate_upload) {
        const sdo::NamedObject object = sdo::named_object(request.data);
        node.server.initiate_upload(request.data, node.objects.read(object.index(), object.subindex()), now);
    } else {
        node.server.receive_command(request.data, now);
    }
}

/// Returns any frame. The prover proves the theorem for each command specifier (bits 5 to 7 of byte 0) separately.
inline Frame any_request() {
    Frame frame = any_frame();
    const std::uint32_t rest = std::uint32_t{frame.data[0]} >> 3U;
    frame.data[0] = static_cast<std::uint8_t>((std::uint32_t{each(8U)} << 5U) | rest);
    return frame;
}

}  // namespace canproof::proofs
