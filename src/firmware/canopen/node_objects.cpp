// SPDX-License-Identifier: Apache-2.0
// Checks accesses to the objects of a node, and applies the effects of writes.

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

}  // namespace

AbortCode Node::check_program(const EntryRef& entry) noexcept {
    return application_.check_access(entry);
}

static_assert(implements<req::CO_SDO_058>);
Result<ByteView, AbortCode> Node::read(const std::uint16_t index, const std::uint8_t subindex) {
    return read_entry(objects_.lookup(index, subindex));
}

/// Serves a request that begins an upload. Most of these requests name a readable number of at most four bytes, which
/// no check of the device concerns: the node reads the number with one access to memory.
void Node::serve_upload(const sdo::Request& request, const Instant now) noexcept {
    const sdo::NamedObject object = sdo::named_object(request);
    const EntryRow* const row = objects_.near_row(object.index(), object.subindex());
    const bool is_number =
        (row != nullptr) && row->may(rights::read) && (row->service != Service::program) && is_short_number(row->type);
    if (is_number && objects_.has_word(*row)) {
        sdo_.upload_number(object, row->size, objects_.short_number(*row));
    } else {
        serve_special_upload(request, EntryRef{row, object.index()}, now);
    }
}

/// Serves a request that begins the upload of any entry. `found` is the entry if near_row() has found it.
void Node::serve_special_upload(const sdo::Request& request, const EntryRef found, const Instant now) noexcept {
    const EntryRef entry = found.exists() ? found : objects_.lookup(found.index, sdo::named_object(request).subindex());
    sdo_.initiate_upload(request, read_entry(entry), now);
}

/// Returns the value of an entry that lookup() returned, or the reason when it cannot be read.
Result<ByteView, AbortCode> Node::read_entry(const EntryRef entry) noexcept {
    using Read = Result<ByteView, AbortCode>;
    const AbortCode code = check_access(entry);
    if (code != AbortCode::none) {
        return Read::failure(code);
    }
    if (!entry.may(rights::read)) {
        return Read::failure(AbortCode::write_only);
    }
    static_assert(implements<req::CO_SDO_032> && implements<req::CO_SDO_061>);
    return (entry.row->type == DataType::domain) ? application_.domain_value(entry)
                                                 : Read::success(objects_.value(entry));
}

Result<WritePlace, AbortCode> Node::writable(const std::uint16_t index, const std::uint8_t subindex) {
    using Place = Result<WritePlace, AbortCode>;
    const EntryRef entry = objects_.lookup(index, subindex);
    const AbortCode code = check_access(entry);
    if (code != AbortCode::none) {
        return Place::failure(code);
    }
    static_assert(implements<req::CO_SDO_009>);
    if (!entry.may(rights::write)) {
        return Place::failure(AbortCode::read_only);
    }
    if (entry.row->type == DataType::domain) {
        const MutableBytes staging = application_.staging(entry);
        return (staging.size() > 0U) ? Place::success(WritePlace{staging.size(), staging})
                                     : Place::failure(AbortCode::out_of_memory);
    }
    const bool is_long = entry.row->size > SdoServer::buffer_size;
    return Place::success(WritePlace{entry.row->size, is_long ? application_.staging(entry) : MutableBytes{}});
}

static_assert(implements<req::CO_SDO_033> && implements<req::CO_SDO_047>);
AbortCode Node::write_domain(const EntryRef& entry, const ByteView value, const Instant now) noexcept {
    MutableBytes staging = application_.staging(entry);
    if (staging.size() == 0U) {
        return AbortCode::out_of_memory;
    }
    if (value.size() > staging.size()) {
        return AbortCode::too_long;
    }
    if (value.data() != staging.view().data()) {
        staging.copy(0U, value);  // an expedited download: its bytes are not in the staging memory yet
    }
    return application_.commit(entry, value.size(), now);
}

static_assert(implements<req::CO_SDO_016>);
AbortCode Node::write(const std::uint16_t index, const std::uint8_t subindex, const ByteView value, const Instant now) {
    const EntryRef entry = objects_.lookup(index, subindex);
    const bool is_plain = entry.exists() && entry.may(rights::write) && (entry.row->service == Service::none) &&
                          !has_variable_length(entry.row->type) && (value.size() == entry.row->size);
    if (!is_plain) {
        return write_special(entry, value, now);
    }
    const std::uint64_t number = number_in(value);
    const AbortCode code = objects_.check_bits(*entry.row, number);
    if (code != AbortCode::none) {
        return code;
    }
    if (objects_.put_bits(*entry.row, number)) {
        note_change(entry, now);
        note_configuration(entry);
    }
    return AbortCode::none;
}

/// Writes an entry that a service or the device owns, or that has a variable length. Returns the reason when an entry
/// cannot be written.
AbortCode Node::write_special(const EntryRef entry, const ByteView value, const Instant now) noexcept {
    AbortCode code = check_access(entry);
    if (code != AbortCode::none) {
        return code;
    }
    if ((entry.row->type == DataType::domain) && entry.may(rights::write)) {
        return write_domain(entry, value, now);
    }
    code = objects_.check_write(entry, value);
    if (code != AbortCode::none) {
        return code;
    }
    const bool is_number = !has_variable_length(entry.row->type);
    const std::uint64_t number = is_number ? number_in(value) : 0U;
    if (entry.row->service == Service::store) {
        // The value is a signature, which starts the save or the restore and is not stored in the entry.
        return store(entry, static_cast<std::uint32_t>(number));
    }
    if (entry.row->service != Service::none) {
        code = before_write(entry, value);
        if (code != AbortCode::none) {
            return code;
        }
    }
    const bool changes = is_number ? objects_.put_bits(*entry.row, number) : objects_.put(entry, value);
    after_put(entry, changes, now);
    if (changes) {
        note_configuration(entry);
    }
    return AbortCode::none;
}

/// Clears 1020h verify configuration (date and time of the configuration tool) when the configuration changes, because
/// date and time refer to the earlier configuration. Process values, which an RPDO may carry, are not part of the
/// configuration.
static_assert(implements<req::CO_VERIFY_001> && implements<req::CO_VERIFY_002> && implements<req::CO_VERIFY_003>);
void Node::forget_verification(const std::uint16_t changed_index) noexcept {
    constexpr std::uint32_t parts = 2U;  // date, time
    for (std::uint8_t subindex = 1U; (changed_index != index::verify_configuration) && (subindex <= parts);
         ++subindex) {
        const EntryRef found = objects_.lookup(index::verify_configuration, subindex);
        if (found.exists() && found.may(rights::write)) {
            static_cast<void>(objects_.put_bits(*found.row, 0U));
        }
    }
}

static_assert(implements<req::CO_STORE_015>);
AbortCode Node::store(const EntryRef& entry, const std::uint32_t value) noexcept {
    const bool wrong_state = profile_.saves_in_pre_operational_only && (state_ != NmtState::pre_operational);
    if (wrong_state && (entry.index == index::store_parameters)) {
        return AbortCode::device_state;
    }
    const AbortCode code = store_.execute(entry, value);
    const bool has_saved = (code == AbortCode::none) && (entry.index == index::store_parameters);
    return has_saved ? application_.save(store_.groups_of(entry)) : code;
}

AbortCode Node::before_received(const EntryRef& entry, const std::uint64_t bits) {
    std::array<std::uint8_t, sizeof(bits)> bytes{};
    MutableBytes{bytes}.put_le<sizeof(bits)>(0U, bits);
    return before_write(entry, ByteView{bytes.data(), entry.row->size});
}

AbortCode Node::before_write(const EntryRef& entry, const ByteView value) noexcept {
    const bool is_devices = (entry.row->service == Service::device) || (entry.row->service == Service::program);
    return is_devices ? application_.before_write(entry, value)
                      : check_parameter(entry, static_cast<std::uint32_t>(number_in(value)));
}

/// Returns AbortCode::none when the service that owns a parameter accepts its new value, otherwise the reason. Such a
/// parameter is a number of at most 32 bits.
AbortCode Node::check_parameter(const EntryRef& entry, const std::uint32_t value) const noexcept {
    switch (entry.row->service) {
        case Service::sync:
            return sync_.before_write(entry, value);
        case Service::emcy:
            return emcy_.before_write(entry, value);
        case Service::heartbeat:
            return (entry.index == HeartbeatConsumer::index) ? heartbeats_.before_write(entry, value) : AbortCode::none;
        case Service::guarding:
            return error_control_.before_write(entry, value);
        case Service::pdo:
            return check_pdo_write(objects_, entry, value);
        case Service::none:
        case Service::store:
        case Service::nmt:
        case Service::error_behaviour:
        case Service::program:
        case Service::lss:
        case Service::device:
        default:
            return AbortCode::none;
    }
}

void Node::after_write(const EntryRef& entry, const Instant now) noexcept {
    switch (entry.row->service) {
        case Service::sync:
            sync_.after_write(now);
            break;
        case Service::emcy:
            emcy_.after_write(entry);
            break;
        case Service::heartbeat:
            if (entry.index == HeartbeatConsumer::index) {
                heartbeats_.after_write(entry);
            } else {
                error_control_.after_write(entry, now);
            }
            break;
        case Service::guarding:
            error_control_.after_write(entry, now);
            break;
        case Service::program:
        case Service::device:
            application_.after_write(entry, now);
            break;
        case Service::pdo:
            rpdos_.after_write(entry);
            tpdos_.after_write(entry, now);
            break;
        case Service::none:
        case Service::store:
        case Service::nmt:
        case Service::error_behaviour:
        case Service::lss:
        default:
            break;
    }
}

}  // namespace canproof
