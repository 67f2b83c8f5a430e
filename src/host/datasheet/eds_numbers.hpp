// Numbers as CiA 306 spells them: decimal, 0x hexadecimal, octal with a leading zero, $NODEID terms, IEEE bits of
// reals; and with the suffixes of C, as some tools write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/register/register.hpp"

namespace canproof::host {

/// An unsigned number; nothing when it is none or does not fit 64 bits.
std::optional<std::uint64_t> eds_unsigned(std::string_view text);

/// The same for digits of a hexadecimal number without the 0x before them.
std::optional<std::uint64_t> eds_hexadecimal(std::string_view digits);

/// A value that may hold the node-ID as a term: `$NODEID+0x180`, `0x180+$NODEID`, `$NODEID`.
struct NodeIdTerm {
    std::string rest;  ///< the number without the term; "0" when it stands alone
    bool has_node_id{false};
};
/// Nothing when $NODEID stands in no sum.
std::optional<NodeIdTerm> split_node_id(const std::string& text);

/// A number as a value of a numeric CiA type; nothing when it is none or does not fit. Hexadecimal numbers of a signed
/// type may be its bit pattern; hexadecimal numbers of a real are its IEEE 754 bits.
std::optional<Value> eds_value(const std::string& text, const std::string& type);

/// `01 A0 FF` or `01A0FF`; nothing when these are no octets.
std::optional<std::string> eds_octets(const std::string& text);

}  // namespace canproof::host
