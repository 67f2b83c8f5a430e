// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_mappings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "host/base/cia301.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

/// One entry of a PDO mapping (CiA 301, 7.5.2.36): index in bits 16 to 31, sub-index in bits 8 to 15, then the length.
struct Mapped {
    explicit Mapped(std::uint32_t value) : index{value >> 16U}, subindex{value >> 8U & 0xFFU}, bits{value & 0xFFU} {}

    std::uint32_t index;
    std::uint32_t subindex;
    std::uint32_t bits;
};

class MappingCheck {
  public:
    MappingCheck(const Part& part, Faults& faults) : part_{part}, faults_{faults} {}

    void check(const Object& mapping) {
        const auto* const count = std::get_if<std::int64_t>(&mapping.entries.front().value);
        for (const Entry& entry : mapping.entries) {
            const auto* const value = std::get_if<std::int64_t>(&entry.value);
            const bool used = count != nullptr && entry.subindex != 0 && entry.subindex <= *count;
            if (used && value != nullptr && *value > 0 && *value <= UINT32_MAX) {
                check(mapping, entry, Mapped{static_cast<std::uint32_t>(*value)});
            }
        }
    }

  private:
    void check(const Object& mapping, const Entry& entry, const Mapped& mapped) {
        if (mapped.index < cia301::first_object) {
            return;  // a data type, which fills bits of an RPDO
        }
        const auto fault = [&](const std::string& what, const std::string& fix) {
            faults_.push_back({entry.default_place,
                               fmt::format("{:04X}h:{} maps {:04X}h:{}, which {}", mapping.index, entry.subindex,
                                           mapped.index, mapped.subindex, what),
                               fix});
        };
        const Entry* const target = find(mapped);
        if (target == nullptr) {
            return fault("is no entry of the device", "correct the default, or add the entry");
        }
        const bool received = mapping.index <= cia301::last_rpdo_mapping;
        const char* const word = received ? "rpdo" : "tpdo";
        if (target->mapping != word && target->mapping != "both") {
            fault(fmt::format("has mapping = \"{}\"", target->mapping),
                  fmt::format("set mapping = \"{}\" or \"both\" there, or correct the default", word));
        }
        const std::size_t bits = 8 * type_size(target->type);
        if (bits != 0 && mapped.bits != bits && !(target->type == "BOOLEAN" && mapped.bits == 1)) {
            fault(fmt::format("has {} bits and not {}", bits, mapped.bits),
                  "correct the last two digits of the default, or the type of the entry");
        }
    }

    const Entry* find(const Mapped& mapped) const {
        const auto object = std::find_if(part_.objects.begin(), part_.objects.end(),
                                         [&](const Object& one) { return one.index == mapped.index; });
        if (object == part_.objects.end()) {
            return nullptr;
        }
        const auto entry = std::find_if(object->entries.begin(), object->entries.end(),
                                        [&](const Entry& one) { return one.subindex == mapped.subindex; });
        return entry == object->entries.end() ? nullptr : &*entry;
    }

    const Part& part_;
    Faults& faults_;
};

}  // namespace

void check_mappings(const Part& part, Faults& faults) {
    MappingCheck check{part, faults};
    for (const Object& object : part.objects) {
        if (cia301::is_pdo_mapping(object.index) && !object.entries.empty()) {
            check.check(object);
        }
    }
}

}  // namespace canproof::host
