// SPDX-License-Identifier: Apache-2.0
// Generates an enumeration of the objects whose writes the firmware reports to the device, so that a compiler can check
// that a switch over them is complete.
#include "host/codegen/write_written.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "host/base/cia301.hpp"
#include "host/codegen/cpp_text.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

/// A range of object indices that contains only families of numbered objects. It consists of `count` blocks of `step`
/// indices each, from index `first` on. Block k contains the object with the number `first_member` + k of each family.
/// `origin` is the first index of the block with the first objects of the families. A family has several stretches when
/// its indices do not have equal distances, for example because they contain only decimal digits (index …09h is
/// followed by …10h).
struct Stretch {
    unsigned first;
    unsigned step;
    unsigned count;
    int first_member;
    unsigned origin;

    unsigned end() const { return first + step * count; }
    bool contains(unsigned index) const { return index >= first && index < end(); }
    bool names(unsigned index) const { return index >= origin && index < origin + step; }
};

/// Returns whether the firmware reports a write to one of the object's entries to the device's own code.
bool is_heard(const Object& object) {
    return std::any_of(object.entries.begin(), object.entries.end(), [&](const Entry& entry) {
        const bool writable = entry.access == "rw" || entry.access == "wo";
        return entry.service == "program" ||
               (writable && entry.service != "none" && object.index >= cia301::first_manufacturer_object);
    });
}

using Families = std::map<std::string, std::vector<const Object*>>;

/// Returns the members of each family in the order of their numbers.
Families families_of(const Part& part) {
    Families families;
    for (const Object& object : part.objects) {
        if (!object.family.empty()) {
            families[object.family].push_back(&object);
        }
    }
    return families;
}

/// Returns the stretches of a family, which must have two or more members. The step of each stretch is the distance
/// between the indices of the first two members.
std::vector<Stretch> stretches_of(const std::vector<const Object*>& members) {
    const unsigned step = members[1]->index - members[0]->index;
    const unsigned origin = members[0]->index / step * step;
    std::vector<Stretch> list;
    for (const Object* const member : members) {
        if (!list.empty() && list.back().contains(member->index - step)) {
            ++list.back().count;
        } else {
            list.push_back({member->index / step * step, step, 1, member->member, origin});
        }
    }
    return list;
}

/// Returns whether each object in the stretch belongs to a family of `size` members and has the same position in its
/// block as the family's first member has.
bool is_pure(const Part& part, const Families& families, const Stretch& stretch, std::size_t size) {
    return std::all_of(part.objects.begin(), part.objects.end(), [&](const Object& object) {
        if (!stretch.contains(object.index)) {
            return true;
        }
        const auto found = families.find(object.family);
        return found != families.end() && found->second.size() == size && stretch.names(found->second.front()->index) &&
               object.index - stretch.first ==
                   static_cast<unsigned>(object.member - stretch.first_member) * stretch.step +
                       (found->second.front()->index - stretch.origin);
    });
}

std::vector<Stretch> stretches_of(const Part& part) {
    const Families families = families_of(part);
    std::map<unsigned, Stretch> all;
    for (const auto& [name, members] : families) {
        if (members.size() < 2 || !is_heard(*members.front())) {
            continue;
        }
        const std::vector<Stretch> own = stretches_of(members);
        const std::size_t count = members.size();
        if (std::all_of(own.begin(), own.end(),
                        [&](const Stretch& one) { return is_pure(part, families, one, count); })) {
            for (const Stretch& one : own) {
                all.emplace(one.first, one);
            }
        }
    }
    std::vector<Stretch> list;
    for (const auto& [first, one] : all) {
        list.push_back(one);
    }
    return list;
}

const Stretch* stretch_at(const std::vector<Stretch>& stretches, unsigned index) {
    const auto found =
        std::find_if(stretches.begin(), stretches.end(), [&](const Stretch& one) { return one.contains(index); });
    return found == stretches.end() ? nullptr : &*found;
}

/// Returns the name of a family as a C++ word: `binary_function_source` for `Binary function {n} source`.
std::string family_word(std::string name) {
    if (const auto at = name.find("{n}"); at != std::string::npos) {
        name.erase(at, 3);
    }
    return cpp_word(name);
}

std::string enumerators(const Part& part, const std::vector<Stretch>& stretches) {
    std::map<std::string, int> uses;
    std::vector<std::pair<std::string, const Object*>> all;
    for (const Object& object : part.objects) {
        const Stretch* const stretch = stretch_at(stretches, object.index);
        const bool is_later = stretch != nullptr && !stretch->names(object.index);
        if (is_heard(object) && !is_later) {
            all.emplace_back(stretch == nullptr ? cpp_word(object.name) : family_word(object.family), &object);
            ++uses[all.back().first];
        }
    }
    std::string text;
    for (const auto& [name, object] : all) {
        const std::string unique = uses[name] == 1 ? name : fmt::format("{}_{:04x}", name, object->index);
        text += fmt::format("    {} = 0x{:04X}U,\n", unique, object->index);
    }
    return text;
}

}  // namespace

std::string write_written(const Part& part) {
    const auto stretches = stretches_of(part);
    std::string text = heading(part);
    text += fmt::format("#include <cstdint>\n\nnamespace canproof::generated::{} {{\n\n", part.cpp_name());
    text +=
        "/// Objects whose writes are reported to the device; the members of a family have one enumerator.\n"
        "enum class Parameter : std::uint16_t {\n" +
        enumerators(part, stretches) + "};\n\n";
    text +=
        "/// The object of a write.\n"
        "struct Written {\n    Parameter parameter;\n"
        "    std::uint8_t member;    ///< number within the family; 0: no family\n"
        "    std::uint8_t subindex;  ///< position in an array, from 1\n};\n\n";
    text +=
        "/// Returns the object of a write; `index` is that of an object in Parameter.\n"
        "constexpr Written written(const std::uint16_t index, const std::uint8_t subindex) noexcept {\n";
    for (const Stretch& one : stretches) {
        text += fmt::format(
            "    if ((index >= 0x{0:04X}U) && (index < 0x{1:04X}U)) {{\n"
            "        const std::uint32_t offset = index - 0x{0:04X}U;\n"
            "        return Written{{static_cast<Parameter>(0x{4:04X}U + (offset % 0x{2:02X}U)),\n"
            "                       static_cast<std::uint8_t>({3}U + (offset / 0x{2:02X}U)), subindex}};\n"
            "    }}\n",
            one.first, one.end(), one.step, one.first_member, one.origin);
    }
    text += "    return Written{static_cast<Parameter>(index), 0U, subindex};\n}\n\n";
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
