// SPDX-License-Identifier: Apache-2.0
#include "host/register/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "host/base/fnv1a.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

std::uint64_t bits_of(const Entry& entry) {
    if (is_real_type(entry.type)) {
        const auto* real = std::get_if<double>(&entry.value);
        const double wide = real != nullptr ? *real : static_cast<double>(std::get<std::int64_t>(entry.value));
        if (entry.type == "REAL64") {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &wide, sizeof bits);
            return bits;
        }
        const auto narrow = static_cast<float>(wide);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &narrow, sizeof bits);
        return bits;
    }
    if (const auto* truth = std::get_if<bool>(&entry.value)) {
        return *truth ? 1U : 0U;
    }
    const auto* whole = std::get_if<std::int64_t>(&entry.value);
    return whole == nullptr ? 0U : static_cast<std::uint64_t>(*whole);
}

/// Returns whether the value never changes and therefore can be in flash.
bool is_constant(const Entry& entry) {
    if (entry.factory || entry.node_id || std::string_view{entry.mapping} != "none") {
        return false;
    }
    const std::string_view access{entry.access};
    return access == "const" || (access == "ro" && !entry.live && std::string_view{entry.service} == "none");
}

std::size_t size_of(const Entry& entry) {
    return is_string_type(entry.type) ? entry.length : type_size(entry.type);
}

/// Appends the entry's default as `size` bytes, like those that value_bytes() returns.
void append_value(std::vector<std::uint8_t>& bytes, const Entry& entry, std::size_t size) {
    if (is_string_type(entry.type)) {
        const auto& text = std::get<std::string>(entry.value);
        const std::size_t end = bytes.size() + size;
        bytes.insert(bytes.end(), text.begin(),
                     text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), size)));
        bytes.resize(end);
        return;
    }
    const std::uint64_t bits = bits_of(entry);
    for (std::size_t i = 0; i < size; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(bits >> (8U * i)));
    }
}

}  // namespace

std::size_t image_size(const Part& part) {
    std::size_t size = 0;
    for (const Object& object : part.objects) {
        for (const Entry& entry : object.entries) {
            size += is_constant(entry) ? 0U : size_of(entry);
        }
    }
    return size;
}

std::vector<std::uint8_t> value_bytes(const Entry& entry, std::size_t size) {
    std::vector<std::uint8_t> bytes;
    append_value(bytes, entry, size);
    return bytes;
}

Layout make_layout(const Part& part) {
    Layout layout;
    std::uint32_t print = fnv1a("");
    std::string stored;
    for (const Object& object : part.objects) {
        const std::string index = fmt::format("{:04X}:", object.index);
        std::vector<Placement> placed;
        placed.reserve(object.entries.size());
        for (const Entry& entry : object.entries) {
            Placement place;
            place.constant = is_constant(entry);
            place.size = static_cast<std::uint16_t>(size_of(entry));
            auto& pool = place.constant ? layout.constants : layout.image;
            place.offset = static_cast<std::uint16_t>(pool.size());
            append_value(pool, entry, place.size);
            if (entry.stored) {
                stored.assign(index);
                const fmt::format_int subindex{entry.subindex};
                const fmt::format_int offset{place.offset};
                stored.append(subindex.data(), subindex.size()).push_back(':');
                stored.append(entry.type).push_back(':');
                stored.append(offset.data(), offset.size()).push_back(';');
                print = fnv1a(stored, print);
            }
            placed.push_back(place);
        }
        layout.placements.push_back(std::move(placed));
    }
    layout.fingerprint = print;
    return layout;
}

}  // namespace canproof::host
