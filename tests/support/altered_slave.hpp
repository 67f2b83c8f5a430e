// SPDX-License-Identifier: Apache-2.0
// A test fixture (bench) with the conformance slave. A test can change the object dictionary of the slave into a valid
// one that no real device has.
#pragma once

#include "tests/support/frame_bench.hpp"
#include "tests/support/slave.hpp"

namespace canproof::test {

/// A bench whose slave has node-ID 5. A test changes `description` (the slave's object dictionary), then calls
/// power_on().
class AlteredSlaveBench : public FrameBench<host::GenericDevice> {
  public:
    AlteredSlaveBench() : FrameBench{4096} {}

    /// Returns an entry of the slave's dictionary.
    EntryRow& entry(std::uint16_t index, std::uint8_t subindex) {
        const ObjectRow& wanted = object(index);
        EntryRow* row = &description.rows.entries.at(wanted.first_entry);
        while (row->subindex != subindex) {
            ++row;
        }
        return *row;
    }
    /// Changes the index of an object to `other`. The objects must stay in ascending order of their indices.
    void renumber(std::uint16_t index, std::uint16_t other) {
        object(index).index = other;
        fill_slots();
    }
    /// Sets the default of a numeric entry.
    void ship(std::uint16_t index, std::uint8_t subindex, std::uint64_t value) {
        const EntryRow& row = entry(index, subindex);
        std::vector<std::uint8_t>& image = description.rows.layout.image;
        write_le(MutableBytes{image.data(), image.size()}, row.offset, row.size, value);
    }
    /// Extends an array to the sub-index `last` with copies of its last element.
    void extend(std::uint16_t index, std::uint8_t last) {
        ObjectRow& array = object(index);
        std::vector<EntryRow>& rows = description.rows.entries;
        while (rows[array.first_entry + array.count - 1U].subindex < last) {
            EntryRow row = rows[array.first_entry + array.count - 1U];
            row.offset = static_cast<std::uint16_t>(description.rows.layout.image.size());
            ++row.subindex;
            description.rows.layout.image.resize(row.offset + std::size_t{row.size});
            rows.insert(rows.begin() + array.first_entry + array.count, row);
            ++array.count;
            for (ObjectRow& later : description.rows.objects) {
                later.first_entry = static_cast<std::uint16_t>(later.first_entry + (later.index > index ? 1U : 0U));
            }
        }
    }
    /// Sets the limits of an entry.
    void limit(std::uint16_t index, std::uint8_t subindex, const LimitRow& limits) {
        description.rows.limits.push_back(limits);
        entry(index, subindex).limit = static_cast<std::uint16_t>(description.rows.limits.size() - 1U);
    }

    /// Powers on a slave with the present `description`; its non-volatile memory keeps its content. Returns the frames
    /// that it sends.
    Frames power_on() {
        queue = TransmitQueue{};
        device = std::make_unique<host::GenericDevice>(description, memory, queue);
        return switch_on([this] { device->power_on(5, now); });
    }

    host::GenericDescription description{slave()};

  private:
    ObjectRow& object(std::uint16_t index) {
        ObjectRow* row = &description.rows.objects.front();
        while (row->index != index) {
            ++row;
        }
        return *row;
    }
    void fill_slots() {
        std::vector<std::uint16_t>& slots = description.rows.slots;
        std::fill(slots.begin(), slots.end(), static_cast<std::uint16_t>(no_object));
        for (std::size_t at = 0; at < description.rows.objects.size(); ++at) {
            std::size_t slot =
                object_slot(description.rows.objects[at].index, description.rows.slot_factor, slots.size());
            while (slots[slot] != no_object) {
                slot = (slot + 1) % slots.size();
            }
            slots[slot] = static_cast<std::uint16_t>(at);
        }
    }
};

}  // namespace canproof::test
