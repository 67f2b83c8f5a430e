// SPDX-License-Identifier: Apache-2.0
#include "host/sim/decode/object_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace canproof::host {

namespace {

const Object* object_at(const Part* part, std::uint16_t index) {
    if (part == nullptr) {
        return nullptr;
    }
    const auto found = std::lower_bound(part->objects.begin(), part->objects.end(), index,
                                        [](const Object& one, std::uint16_t wanted) { return one.index < wanted; });
    return found != part->objects.end() && found->index == index ? &*found : nullptr;
}

std::string digits(ByteView bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        text += fmt::format("{}{:02X}", i == 0 ? "" : " ", bytes[i]);
    }
    return text;
}

/// Returns the signed value of `size` bytes in two's complement.
std::int64_t signed_value(std::uint64_t bits, std::size_t size) {
    const unsigned spare = 64U - 8U * static_cast<unsigned>(size);
    return static_cast<std::int64_t>(bits << spare) >> spare;
}

std::string text_of(ByteView bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size() && bytes[i] != 0U; ++i) {
        text += std::isprint(bytes[i]) != 0 ? static_cast<char>(bytes[i]) : '?';
    }
    return '"' + text + '"';
}

}  // namespace

const Entry* entry_at(const Part* part, std::uint16_t index, std::uint8_t subindex) {
    const Object* const object = object_at(part, index);
    if (object == nullptr) {
        return nullptr;
    }
    const auto found = std::find_if(object->entries.begin(), object->entries.end(),
                                    [&](const Entry& one) { return one.subindex == subindex; });
    return found == object->entries.end() ? nullptr : &*found;
}

std::string entry_words(const Part* part, std::uint16_t index, std::uint8_t subindex) {
    const Object* const object = object_at(part, index);
    const bool single = object != nullptr && object->kind == Object::Kind::var && subindex == 0U;
    const std::string place = single ? fmt::format("{:04X}h", index) : fmt::format("{:04X}h:{}", index, subindex);
    const Entry* const entry = entry_at(part, index, subindex);
    return entry == nullptr ? place : place + " " + entry->name;
}

std::string value_words(const Entry* entry, ByteView bytes) {
    if (entry == nullptr) {
        return digits(bytes);
    }
    if (entry->type == "VISIBLE_STRING") {
        return text_of(bytes);
    }
    if (bytes.size() != type_size(entry->type) || bytes.size() == 0U) {
        return digits(bytes);
    }
    const std::uint64_t bits = read_le(bytes, 0U, bytes.size());
    if (entry->type == "BOOLEAN") {
        return bits != 0U ? "true" : "false";
    }
    if (entry->type == "REAL32") {
        return fmt::format("{:.6g}", bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    if (entry->type == "REAL64") {
        return fmt::format("{:.9g}", bit_cast<double>(bits));
    }
    if (entry->type.rfind("INTEGER", 0) == 0) {
        return std::to_string(signed_value(bits, bytes.size()));
    }
    // Identifiers, mappings and device types are easiest to read in hexadecimal.
    return entry->type == "UNSIGNED32" && bits > 0xFFFFU ? fmt::format("{:08X}h", bits) : std::to_string(bits);
}

}  // namespace canproof::host
