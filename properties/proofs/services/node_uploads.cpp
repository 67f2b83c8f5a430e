// SPDX-License-Identifier: Apache-2.0
// Theorem on uploads from the dictionary: the node answers each upload as the SDO server answers the value that is
// read.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/any_node.hpp"
#include "properties/proofs/support/queue.hpp"

namespace canproof::proofs {

namespace {

/// A device that may refuse the access to any entry of Service::program.
class RefusingApplication final : public QuietApplication {
  public:
    AbortCode check_access(const EntryRef& /*entry*/) override { return answer_; }

    AbortCode answer_{any<AbortCode>()};
};

/// A node whose dictionary has one object with one entry: any entry that is_sound() of a compiled dictionary permits.
struct NodeOfOneEntry {
    static constexpr std::size_t most = 8U;

    std::array<ObjectRow, 1U> rows{{{0x2000U, 0U, 1U, ObjectKind::var}}};
    std::array<EntryRow, 1U> entries{{any<EntryRow>()}};
    std::array<std::uint16_t, 2U> slots{{0U, static_cast<std::uint16_t>(no_object)}};
    std::array<std::uint8_t, most> constants{any<std::array<std::uint8_t, most>>()};
    std::array<std::uint8_t, most> image{any<std::array<std::uint8_t, most>>()};
    DictionaryTables tables{table_view(rows),
                            table_view(entries),
                            {},
                            {},
                            table_view(constants),
                            table_view(image),
                            0U,
                            table_view(slots),
                            0U,
                            SIZE_MAX};
    ObjectDictionary objects{tables, MutableBytes{image}, LimitAbort::range};
    EmptyMemory memory{};
    TransmitQueue queue{};
    RefusingApplication application{};
    ErrorTable errors{};
    Node node{objects, memory, queue, application, errors, NodeProfile{}, PdoMemory{}};

    NodeOfOneEntry() {
        EntryRow& row = entries[0];
        row.subindex = 0U;
        row.limit = static_cast<std::uint16_t>(no_limit);
        row.offset = each(most + 1U);
        row.size = each(most + 1U);
        assume((std::size_t{row.offset} + row.size) <= most);
        assume(!is_short_number(row.type) || ((row.size >= 1U) && (row.size <= 4U)));
        leave_open(node.sdo_);
    }
};

}  // namespace

void an_upload_of_any_entry_is_answered_with_what_is_read() {
    shows(
        "a request that begins an upload from a dictionary with one entry of any type, rights, service and place, of "
        "up to eight bytes, in any state of the SDO server, gets the same answer as the SDO server gives to the value "
        "or the abort code that is read; a write-only entry is refused");
    proves<req::CO_SDO_001, req::CO_SDO_002, req::CO_SDO_058>();
    NodeOfOneEntry one{};
    auto request = any<sdo::Request>();
    set_field_le<sdo::index_position, 2U>(request, 0x2000U);
    request[sdo::subindex_position] = 0U;
    const Instant now = any_time();
    TransmitQueue queue{};
    SdoServer server{one.node, queue, false};
    server.response_id_ = one.node.sdo_.response_id_;
    const auto read = one.node.read(0x2000U, 0U);
    server.initiate_upload(request, read, now);
    one.node.serve_upload(request, now);
    claim((one.queue.size() == 1U) && (queue.size() == 1U));
    claim(is_same(waiting(one.queue, 0U), waiting(queue, 0U)));
    claim((one.node.sdo_.state_ == server.state_) && (one.node.sdo_.idle_until_ == server.idle_until_));
    const bool is_write_only = !one.entries[0].may(rights::read) && (one.entries[0].service != Service::program);
    claim(!is_write_only || (!read.ok() && (read.error() == AbortCode::write_only)));
}

void an_upload_is_answered_with_what_is_read() {
    shows(
        "a request that begins an upload from any object of the CAN-CBX-AO412 and any sub-index, in any state of a "
        "node without PDOs and of its SDO server, gets the same answer as the SDO server gives to the value or the "
        "abort code that is read; it changes no byte of the image");
    proves<req::CO_SDO_001, req::CO_SDO_002>();
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
