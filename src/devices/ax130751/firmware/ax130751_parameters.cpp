// SPDX-License-Identifier: Apache-2.0
// Checks new values of parameters and applies their effects.

#include "devices/ax130751/firmware/ax130751.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/index.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace index = generated::ax130751::index;

// Distance from 3yz0h of a table to its responses, and to the X of its points.
constexpr std::uint32_t point_response_offset = index::lt1_point_response - index::lt1_input_x_axis_source;
constexpr std::uint32_t point_x_offset = index::lt1_point_x_axis_pv - index::lt1_input_x_axis_source;

bool is_field_value(const std::uint16_t index) noexcept {
    return (index == index::ao_override_field_value) || (index == index::ao_output_scaling_1_fv) ||
           (index == index::ao_output_scaling_2_fv) || (index == index::ao_fault_field_value);
}

std::int16_t to_int16(const ByteView value) noexcept {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(read_le(value, 0U, sizeof(std::int16_t))));
}

std::int32_t to_int32(const ByteView value) noexcept {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(read_le(value, 0U, sizeof(std::int32_t))));
}

}  // namespace

AbortCode Device::before_write(const EntryRef& entry, const ByteView value) {
    const TableEntry place = table_entry(entry.index);
    if (place.offset == point_x_offset) {
        return check_point(objects_, sources_, place.table, entry.row->subindex, to_int32(value));
    }
    return is_field_value(entry.index) ? universal_[entry.row->subindex - 1U].check_field_value(to_int16(value))
                                       : AbortCode::none;
}

static_assert(implements<req::AOR_OUT_022> && implements<req::AOR_LT_018>);
void Device::after_write(const EntryRef& entry, const Instant) {
    const TableEntry place = table_entry(entry.index);
    if (place.table != 0U) {
        if ((place.offset == point_response_offset) && (entry.row->subindex == 1U) &&
            is_over_time(objects_, place.table)) {
            begin_time_response(objects_, place.table);
        }
        tables_[place.table - 1U].reread();
    }
    if (entry.index == index::ao_output_type) {
        const std::uint8_t output = entry.row->subindex;
        const std::uint16_t type = objects_.get(field::o6310_ao_output_type[output]);
        if (std::uint32_t{type} != types_[output - 1U]) {
            types_[output - 1U] = type;
            universal_[output - 1U].take_type_defaults();
        }
    }
    follow_minima(entry);
}

/// Moves the first points after a write. It need not run in each cycle, because a minimum depends only on parameters.
void Device::follow_minima(const EntryRef& entry) noexcept {
    for (std::uint8_t table = 1U; table <= table_count; ++table) {
        if (first_points_[table - 1U].follow(table, entry, objects_, sources_)) {
            tables_[table - 1U].reread();
        }
    }
}

}  // namespace canproof::ax130751
