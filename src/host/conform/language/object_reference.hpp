// SPDX-License-Identifier: Apache-2.0
// A reference to an object in a step of a conformance case: `1017:00`, `$P.comm:01`, `(1A00+$k):01`, or an entry `$E`.
#pragma once

#include <cstdint>
#include <functional>

#include "host/conform/language/scanner.hpp"
#include "host/conform/language/value.hpp"

namespace canproof::host::conform {

struct ObjectPlace {
    std::uint16_t index{0};
    std::uint8_t subindex{0};

    bool operator<(const ObjectPlace& other) const {
        return index != other.index ? index < other.index : subindex < other.subindex;
    }
    bool operator==(const ObjectPlace& other) const { return index == other.index && subindex == other.subindex; }
};

/// Returns index and sub-index as text: `1017h:00`.
std::string words_of(const ObjectPlace& place);
/// Returns index and sub-index in the three bytes of an SDO frame.
Bytes multiplexer(const ObjectPlace& place);

using ObjectReference = std::function<ObjectPlace(const Scope&)>;

/// Parses an object reference such as `1017:00`. Throws LanguageError.
ObjectReference parse_object(Scanner& line);

}  // namespace canproof::host::conform
