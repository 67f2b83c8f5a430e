// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/write_dbc.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "host/base/cia301.hpp"
#include "host/datasheet/dbc_text.hpp"
#include "host/datasheet/entry_index.hpp"
#include "host/datasheet/entry_words.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

constexpr unsigned multiplexed_pdo = 254;
constexpr unsigned pdo_bits = 64;
/// With this length of the device's part, a message name contains the whole name of its service. The longest service
/// name is `SDO response`.
constexpr std::size_t longest_prefix = DbcNames::longest_name - sizeof "_SDO_response" + 1;

DbcSignal::Number number_kind(const std::string& type) {
    return type == "REAL32"                 ? DbcSignal::Number::single_real
           : type == "REAL64"               ? DbcSignal::Number::double_real
           : type.rfind("INTEGER", 0) == 0U ? DbcSignal::Number::integer
                                            : DbcSignal::Number::natural;
}

/// Returns the signal of an entry. Its name, position and length are not set.
DbcSignal signal_of(const NamedEntry& named) {
    DbcSignal signal;
    const Entry& entry = *named.entry;
    signal.number = number_kind(entry.type);
    const bool counts = named.object->kind != Object::Kind::var && entry.subindex == 0;
    signal.unit = counts ? "" : named.object->unit;
    signal.comment = fmt::format("{} {}", place_words(*named.object, *named.entry), full_name(named));
    const Range& range = entry.range;
    if (range.minimum.kind == Limit::Kind::number && range.maximum.kind == Limit::Kind::number) {
        signal.minimum = number_of(range.minimum.number).value_or(0.0);
        signal.maximum = number_of(range.maximum.number).value_or(0.0);
    }
    return signal;
}

DbcSignal plain_signal(const char* name, unsigned start, unsigned length, DbcWords words = {}) {
    DbcSignal signal;
    signal.name = name;
    signal.start = start;
    signal.length = length;
    signal.words = std::move(words);
    return signal;
}

class DbcWriter {
  public:
    DbcWriter(const Part& part, unsigned node_id) : part_{part}, node_id_{node_id}, entries_{part} {
        DbcNames nodes;
        host_ = nodes.take("Host");
        device_ = nodes.take(part.name);
        prefix_ = DbcNames{longest_prefix}.take(part.name);
    }

    std::string text() {
        file_.nodes = {host_, device_};
        add_network();
        for (unsigned number = 0; number < 512; ++number) {
            add_pdo(cia301::rpdo_communication + number);
        }
        for (unsigned number = 0; number < 512; ++number) {
            add_pdo(cia301::tpdo_communication + number);
        }
        add_sdo();
        file_.comment = fmt::format("{} at node-ID {}, written by canproof", part_.name, node_id_);
        if (!left_out_.empty()) {
            file_.comment += fmt::format("; left out: {}", fmt::join(left_out_, ", "));
        }
        return dbc_text(file_);
    }

  private:
    std::optional<std::uint32_t> number(unsigned index, unsigned sub) const {
        return entries_.number(index, sub, node_id_);
    }

    /// Adds a message with this COB-ID. Returns nullptr when the COB-ID is switched off or another message has the same
    /// identifier.
    DbcMessage* add(std::uint32_t cob_id, const std::string& name, unsigned length, bool from_device) {
        const bool extended = (cob_id & cob_id_extended) != 0;
        const std::uint32_t id = cob_id & (extended ? 0x1FFFFFFFU : 0x7FFU);
        const bool off = (cob_id & cob_id_switched_off) != 0;
        if (off || !ids_.insert({id, extended}).second) {
            left_out_.push_back(
                fmt::format("{} {}", name, off ? "is switched off" : "has the identifier of another message"));
            return nullptr;
        }
        DbcMessage message;
        message.id = id;
        message.is_extended = extended;
        message.name = messages_.take(prefix_ + " " + name);
        message.length = length;
        message.sender = from_device ? device_ : host_;
        message.receiver = from_device ? host_ : device_;
        file_.messages.push_back(std::move(message));
        return &file_.messages.back();
    }

    void add_network() {
        if (DbcMessage* nmt = add(0, "NMT", 2, false)) {
            nmt->signals = {plain_signal("Command", 0, 8,
                                         {{0x01, "start"},
                                          {0x02, "stop"},
                                          {0x80, "enter pre-operational"},
                                          {0x81, "reset node"},
                                          {0x82, "reset communication"}}),
                            plain_signal("NodeId", 8, 8, {{0, "all"}})};
        }
        if (const auto sync = number(cia301::sync_cob_id, 0)) {
            const bool counts = number(cia301::sync_counter_overflow, 0).value_or(0) > 1;
            DbcMessage* message = add(*sync, "SYNC", counts ? 1 : 0, false);
            if (message != nullptr && counts) {
                message->signals = {plain_signal("Counter", 0, 8)};
            }
        }
        // Without 1014h COB-ID EMCY, the message has the identifier of the pre-defined connection set.
        if (DbcMessage* emcy = add(number(cia301::emcy_cob_id, 0).value_or(0x80 + node_id_), "EMCY", 8, true)) {
            emcy->signals = {plain_signal("ErrorCode", 0, 16,
                                          {{0x0000, "no error"},
                                           {0x8110, "CAN overrun"},
                                           {0x8120, "error passive"},
                                           {0x8130, "heartbeat or life guarding"},
                                           {0x8140, "recovered from bus-off"},
                                           {0x8210, "PDO too short"},
                                           {0x8220, "PDO too long"},
                                           {0x8240, "length of SYNC"},
                                           {0x8250, "RPDO time-out"}}),
                             plain_signal("ErrorRegister", 16, 8), plain_signal("Manufacturer", 24, 40)};
        }
        if (DbcMessage* heartbeat = add(0x700 + node_id_, "Heartbeat", 1, true)) {
            heartbeat->signals = {
                plain_signal("State", 0, 7,
                             {{0x00, "boot-up"}, {0x04, "stopped"}, {0x05, "operational"}, {0x7F, "pre-operational"}}),
                plain_signal("Toggle", 7, 1)};
        }
    }

    void add_pdo(unsigned index) {
        const auto cob_id = number(index, 1);
        const auto count = number(index + 0x200, 0);
        if (!cob_id || !count || *count == 0 || *count >= multiplexed_pdo) {
            return;
        }
        const bool is_rpdo = index < cia301::tpdo_communication;
        std::vector<DbcSignal> signals;
        DbcNames names;
        unsigned at = 0;
        for (unsigned sub = 1; sub <= *count && at <= pdo_bits; ++sub) {
            const std::uint32_t mapped = number(index + 0x200, sub).value_or(0);
            const unsigned length = mapped & 0xFFU;
            const NamedEntry* target = entries_.named(mapped >> 16U, (mapped >> 8U) & 0xFFU);
            if (target != nullptr && length != 0 && at + length <= pdo_bits) {
                DbcSignal signal = signal_of(*target);
                signal.name = names.take(full_name(*target));
                signal.start = at;
                signal.length = length;
                const bool whole = mapped_bits(*target->entry) == length;
                const bool integer = signal.number == DbcSignal::Number::integer;
                signal.number = whole || integer ? signal.number : DbcSignal::Number::natural;
                signals.push_back(std::move(signal));
            }
            at += length;  // a mapped data type (dummy mapping) leaves a gap of its length
        }
        const std::string name = fmt::format("{}PDO{}", is_rpdo ? "R" : "T", (index & 0x1FFU) + 1);
        if (DbcMessage* pdo = add(*cob_id, name, std::min(at, pdo_bits) / 8 + (at % 8 == 0 ? 0 : 1), !is_rpdo)) {
            pdo->signals = std::move(signals);
            pdo->comment = fmt::format("{:04X}h, as mapped by default", index);
        }
    }

    void add_sdo() {
        const DbcWords requests{{0x22, "download"},
                                {0x23, "download 4 bytes"},
                                {0x27, "download 3 bytes"},
                                {0x2B, "download 2 bytes"},
                                {0x2F, "download 1 byte"},
                                {0x40, "upload"},
                                {0x80, "abort"}};
        const DbcWords responses{{0x43, "upload 4 bytes"}, {0x47, "upload 3 bytes"}, {0x4B, "upload 2 bytes"},
                                 {0x4F, "upload 1 byte"},  {0x60, "download done"},  {0x80, "abort"}};
        if (DbcMessage* request = add(0x600 + node_id_, "SDO request", 8, false)) {
            fill_sdo(*request, requests,
                     [](const Entry& entry) { return entry.access == "rw" || entry.access == "wo"; });
        }
        if (DbcMessage* response = add(0x580 + node_id_, "SDO response", 8, true)) {
            fill_sdo(*response, responses, [](const Entry& entry) { return entry.access != "wo"; });
        }
    }

    template <typename Carried>
    void fill_sdo(DbcMessage& message, const DbcWords& commands, const Carried& carried) const {
        DbcNames names;
        message.signals.push_back(plain_signal(names.take("Command").c_str(), 0, 8, commands));
        DbcSignal object = plain_signal(names.take("Object").c_str(), 8, 24);
        object.multiplex = DbcSignal::Multiplex::switches;
        message.signals.push_back(object);
        DbcWords titles;
        for (const auto& [number, found] : entries_.all()) {
            const std::size_t bytes = type_size(found.entry->type);
            if (bytes == 0 || bytes > 4 || !carried(*found.entry)) {
                continue;
            }
            DbcSignal signal = signal_of(found);
            signal.name = names.take(
                fmt::format("x{:04X}_{:02X}_{}", found.object->index, found.entry->subindex, full_name(found)));
            signal.start = 32;
            signal.length = static_cast<unsigned>(bytes * 8U);
            signal.multiplex = DbcSignal::Multiplex::switched;
            signal.switched_by = (number >> 8U) | ((number & 0xFFU) << 16U);
            titles.emplace_back(signal.switched_by, place_words(*found.object, *found.entry));
            message.signals.push_back(std::move(signal));
        }
        message.signals[1].words = std::move(titles);
    }

    const Part& part_;
    unsigned node_id_;
    EntryIndex entries_;
    std::string host_;
    std::string device_;
    std::string prefix_;  ///< the device's part of the message names
    DbcFile file_;
    DbcNames messages_;
    std::set<std::pair<std::uint32_t, bool>> ids_;
    std::vector<std::string> left_out_;
};

}  // namespace

std::string write_dbc(const Part& part, unsigned node_id) {
    return DbcWriter{part, node_id}.text();
}

}  // namespace canproof::host
