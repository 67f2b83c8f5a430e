// SPDX-License-Identifier: Apache-2.0
// Numbers in the spelling of CiA 306: decimal, 0x hexadecimal, octal with a leading zero, $NODEID terms, IEEE bits of
// reals. The suffixes of C are accepted, because some tools write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/register/register.hpp"

namespace canproof::host {

/// Parses an unsigned number. Returns nothing for any other text and for a number beyond 64 bits.
std::optional<std::uint64_t> eds_unsigned(std::string_view text);

/// Parses hexadecimal digits without 0x. Returns nothing for any other text and for a number beyond 64 bits.
std::optional<std::uint64_t> eds_hexadecimal(std::string_view digits);

/// A value that may contain the node-ID as a term: `$NODEID+0x180`, `0x180+$NODEID`, `$NODEID`.
struct NodeIdTerm {
    std::string rest;  ///< number without the term; "0" when the term is alone
    bool has_node_id{false};
};
/// Separates the term $NODEID, if there is one, from the number. Returns nothing for any other text with `$`.
std::optional<NodeIdTerm> split_node_id(std::string_view text);

/// Parses a value of a numeric CiA type. Returns nothing for any other text and for a value that does not fit. For a
/// signed type, a hexadecimal number can be the bit pattern of the value; for a real type, it is the IEEE 754 bits.
std::optional<Value> eds_value(std::string_view text, const std::string& type);

/// Parses hexadecimal bytes: `01 A0 FF` or `01A0FF`. Returns nothing for any other text.
std::optional<std::string> eds_octets(std::string_view text);

}  // namespace canproof::host
