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

/// Returns whether a PDO mapping can name the entry.
bool is_mappable(const Entry& entry) {
    return std::string_view{entry.mapping} != "none";
}

/// Returns whether the value never changes and therefore can be in flash.
bool is_constant(const Entry& entry) {
    if (entry.factory || entry.node_id || is_mappable(entry)) {
        return false;
    }
    const std::string_view access{entry.access};
    return access == "const" || (access == "ro" && !entry.live && std::string_view{entry.service} == "none");
}

/// Returns whether the value changes only when it is written or loaded.
bool is_setting(const Entry& entry) {
    return (entry.stored || entry.factory) && !entry.live && !is_mappable(entry);
}

std::size_t in_whole_words(std::size_t size) {
    constexpr std::size_t word = 4;
    return (size + word - 1) / word * word;
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
    std::size_t settings = 0;
    std::size_t others = 0;
    for (const Object& object : part.objects) {
        for (const Entry& entry : object.entries) {
            (is_setting(entry) ? settings : others) += is_constant(entry) ? 0U : size_of(entry);
        }
    }
    return in_whole_words(others) + in_whole_words(settings);
}

std::vector<std::uint8_t> value_bytes(const Entry& entry, std::size_t size) {
    std::vector<std::uint8_t> bytes;
    append_value(bytes, entry, size);
    return bytes;
}

namespace {

/// Appends the defaults of all settings, or of all other values, to the image. Sets the places of these values.
void place_in_image(const Part& part, bool settings, Layout& layout) {
    for (std::size_t o = 0; o < part.objects.size(); ++o) {
        for (std::size_t e = 0; e < part.objects[o].entries.size(); ++e) {
            const Entry& entry = part.objects[o].entries[e];
            Placement& place = layout.placements[o][e];
            if (!place.constant && is_setting(entry) == settings) {
                place.offset = static_cast<std::uint16_t>(layout.image.size());
                append_value(layout.image, entry, place.size);
            }
        }
    }
    layout.image.resize(in_whole_words(layout.image.size()));
}

void append_limit(std::string& text, const Limit& limit) {
    if (limit.kind == Limit::Kind::number) {
        text.append(to_text(limit.number));
    } else if (limit.kind == Limit::Kind::object) {
        text.append(fmt::format("{:04X}:{}{:+}", limit.index, limit.subindex, limit.add));
    }
    text.push_back(';');
}

/// Appends what a stored value or a stored line of a PDO mapping must agree with: the place, type, length, rights and
/// allowed values of the entry.
void append_stored(std::string& text, const Entry& entry, const Placement& place) {
    text.append(fmt::format("{}:{}:{}:{};{};{};{};", entry.subindex, entry.type, place.offset, place.size, entry.access,
                            entry.mapping, entry.node_id ? "node-ID" : ""));
    append_limit(text, entry.range.minimum);
    append_limit(text, entry.range.maximum);
    text.append(entry.range.zero ? "0;" : ";");
    for (const Value& value : entry.range.values) {
        text.append(to_text(value)).push_back(',');
    }
    text.push_back(';');
}

std::uint32_t fingerprint_of(const Part& part, const Layout& layout) {
    std::uint32_t print = fnv1a("");
    std::string stored;
    for (std::size_t o = 0; o < part.objects.size(); ++o) {
        const Object& object = part.objects[o];
        const std::string index = fmt::format("{:04X}:", object.index);
        for (std::size_t e = 0; e < object.entries.size(); ++e) {
            const Entry& entry = object.entries[e];
            if (entry.stored || is_mappable(entry)) {
                stored.assign(index);
                append_stored(stored, entry, layout.placements[o][e]);
                print = fnv1a(stored, print);
            }
        }
    }
    return print;
}

}  // namespace

Layout make_layout(const Part& part) {
    Layout layout;
    for (const Object& object : part.objects) {
        std::vector<Placement> placed;
        placed.reserve(object.entries.size());
        for (const Entry& entry : object.entries) {
            Placement place;
            place.constant = is_constant(entry);
            place.size = static_cast<std::uint16_t>(size_of(entry));
            if (place.constant) {
                place.offset = static_cast<std::uint16_t>(layout.constants.size());
                append_value(layout.constants, entry, place.size);
            }
            placed.push_back(place);
        }
        layout.placements.push_back(std::move(placed));
    }
    place_in_image(part, false, layout);
    layout.settings_at = layout.image.size();
    place_in_image(part, true, layout);
    layout.fingerprint = fingerprint_of(part, layout);
    return layout;
}

}  // namespace canproof::host
