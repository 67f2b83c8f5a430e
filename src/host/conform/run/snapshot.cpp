// SPDX-License-Identifier: Apache-2.0
#include "host/conform/run/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/cia301.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::uint32_t cob_id_off = 0x80000000U;
constexpr std::uint32_t sync_producer = 0x40000000U;
constexpr std::uint16_t mapping_offset = 0x200;

/// Returns whether the object cannot be restored by a write, because a write to it is a command or clears a list.
bool is_command(std::uint16_t index) {
    return index == cia301::error_list || index == cia301::store_parameters || index == cia301::restore_parameters ||
           (index >= cia301::program_data && index < cia301::nmt_startup);
}

bool is_pdo(std::uint16_t index) {
    return index >= cia301::rpdo_communication && index <= cia301::last_tpdo_mapping;
}

/// Returns the communication parameter object of a mapping object: 1400h… for 1600h…, 1800h… for 1A00h….
std::uint16_t communication_of(std::uint16_t index) {
    return (index & mapping_offset) != 0 ? static_cast<std::uint16_t>(index - mapping_offset) : index;
}

/// Returns whether the entry is a COB-ID whose bits 0 to 30 may change only while bit 31 (not valid) is set.
bool is_cob_id(const ObjectPlace& place) {
    return place.index == cia301::time_cob_id || place.index == cia301::emcy_cob_id ||
           (place.index >= cia301::sdo_server_parameter && place.index <= cia301::last_sdo_client_parameter &&
            (place.subindex == 1 || place.subindex == 2));
}

}  // namespace

std::set<ObjectPlace> Snapshot::places() const {
    Places all;
    for (const auto& [place, value] : values_) {
        all.insert(place);
    }
    return all;
}

const Bytes* Snapshot::find(const ObjectPlace& place) const {
    const auto found = values_.find(place);
    return found == values_.end() ? nullptr : &found->second;
}

std::vector<std::string> Snapshot::take(SdoClient& sdo, const ConformSheet& sheet) {
    std::vector<std::string> troubles;
    values_.clear();
    for (const Object& object : sheet.part.objects) {
        for (const Entry& entry : object.entries) {
            const bool parameter = entry.access == "rw" && entry.type != "DOMAIN" && !is_command(object.index);
            if (!parameter || entry_size(entry) > longest_value) {
                continue;
            }
            const ObjectPlace place{object.index, entry.subindex};
            try {
                const SdoOutcome outcome = sdo.read(place);
                if (outcome.abort == 0 && !outcome.data.empty()) {
                    values_[place] = outcome.data;
                }
            } catch (const SlaveFailed& failed) {
                troubles.push_back(
                    fmt::format("{:04X}h:{:02X} cannot be read: {}", place.index, place.subindex, failed.what()));
            }
        }
    }
    return troubles;
}

Snapshot::Places Snapshot::changed(SdoClient& sdo, const Places& places) const {
    Places all;
    for (const ObjectPlace& one : places) {
        const Bytes* const before = find(one);
        if (before != nullptr) {
            const SdoOutcome now = sdo.read(one);
            if (now.abort != 0 || now.data != *before) {
                all.insert(one);
            }
        }
    }
    return all;
}

void Snapshot::write(SdoClient& sdo, const ObjectPlace& place) {
    if (const Bytes* const value = find(place)) {
        sdo.write(place, *value, Transfer::automatic);
    }
}

void Snapshot::write(SdoClient& sdo, const ObjectPlace& place, std::int64_t number) {
    if (const Bytes* const value = find(place)) {
        sdo.write(place, little_endian(number, value->size()), Transfer::automatic);
    }
}

/// Restores a PDO in this order: COB-ID with bit 31 (not valid), number of mapped objects 0, mapping entries, number of
/// mapped objects, other parameters, COB-ID.
void Snapshot::put_back_pdo(SdoClient& sdo, std::uint16_t communication, Places& open) {
    const ObjectPlace cob_id{communication, 1};
    const auto mapping = static_cast<std::uint16_t>(communication + mapping_offset);
    if (const Bytes* const id = find(cob_id)) {
        write(sdo, cob_id, from_little_endian(*id, 0, 4) | cob_id_off);
    }
    if (std::any_of(open.begin(), open.end(), [&](const ObjectPlace& one) { return one.index == mapping; })) {
        write(sdo, {mapping, 0}, 0);
        for (auto one = values_.lower_bound({mapping, 1}); one != values_.end() && one->first.index == mapping; ++one) {
            write(sdo, one->first);
        }
        write(sdo, {mapping, 0});
    }
    for (auto one = values_.lower_bound({communication, 2}); one != values_.end() && one->first.index == communication;
         ++one) {
        if (open.count(one->first) != 0) {
            write(sdo, one->first);
        }
    }
    write(sdo, cob_id);
    for (auto one = open.begin(); one != open.end();) {
        one = one->index == communication || one->index == mapping ? open.erase(one) : std::next(one);
    }
}

/// Restores the SYNC objects. The counter overflow value may change only while the slave sends no SYNC.
void Snapshot::put_back_sync(SdoClient& sdo, Places& open) {
    const std::array<std::uint16_t, 3> order{cia301::sync_counter_overflow, cia301::sync_period, cia301::sync_cob_id};
    const bool wanted = std::any_of(order.begin(), order.end(), [&](std::uint16_t index) {
        return open.count({index, 0}) != 0;
    });
    const Bytes* const id = find({cia301::sync_cob_id, 0});
    if (!wanted || id == nullptr) {
        return;
    }
    write(sdo, {cia301::sync_cob_id, 0}, from_little_endian(*id, 0, 4) & ~std::int64_t{sync_producer});
    write(sdo, {cia301::sync_period, 0}, 0);
    for (const std::uint16_t index : order) {
        write(sdo, {index, 0});
        open.erase({index, 0});
    }
}

void Snapshot::put_back_others(SdoClient& sdo, const Places& open) {
    for (const ObjectPlace& one : open) {
        if (one.index == cia301::consumer_heartbeat_time) {
            // 0 first, because two entries of 1016h (consumer heartbeat time) must not contain the same node-ID
            write(sdo, one, 0);
        } else if (is_cob_id(one)) {
            write(sdo, one, from_little_endian(*find(one), 0, 4) | cob_id_off);
        }
    }
    for (const ObjectPlace& one : open) {
        write(sdo, one);
    }
}

std::vector<std::string> Snapshot::put_back(SdoClient& sdo, const std::set<ObjectPlace>& places) {
    Places open = changed(sdo, places);
    const Places wanted = open;
    has_written_ = !open.empty();
    std::set<std::uint16_t> pdos;
    for (const ObjectPlace& one : open) {
        if (is_pdo(one.index)) {
            pdos.insert(communication_of(one.index));
        }
    }
    for (const std::uint16_t one : pdos) {
        put_back_pdo(sdo, one, open);
    }
    put_back_sync(sdo, open);
    put_back_others(sdo, open);
    std::vector<std::string> left;
    for (const ObjectPlace& one : changed(sdo, wanted)) {
        left.push_back(fmt::format("{} does not accept its former value {}", words_of(one), hex_words(*find(one))));
    }
    return left;
}

}  // namespace canproof::host::conform
