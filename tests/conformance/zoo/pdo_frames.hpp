// SPDX-License-Identifier: Apache-2.0
// Reads and builds PDOs according to the dictionary of a wrong slave.
#pragma once

#include <optional>

#include "tests/conformance/zoo/sdo_frames.hpp"

namespace canproof::test::zoo {

constexpr unsigned pdo_count = 4;  ///< in each direction
constexpr std::uint16_t rpdo_communication = 0x1400;
constexpr std::uint16_t tpdo_communication = 0x1800;
constexpr std::uint16_t mapping_offset = 0x200;

/// How the mapped values are ordered in a PDO.
enum class Packing { right, reversed, bytewise };

/// Returns sub-index `sub` of the communication parameters of PDO `number`, which counts from 0.
std::uint32_t pdo_parameter(WrongSlave& slave, std::uint16_t communication, unsigned number, std::uint8_t sub);
bool is_valid_pdo(WrongSlave& slave, std::uint16_t communication, unsigned number);
/// Returns the number of the PDO whose identifier is that of `frame`, or nothing if there is none. Searches the valid
/// PDOs, or those that are not valid when `valid` is false.
std::optional<unsigned> pdo_of(WrongSlave& slave, std::uint16_t communication, const Frame& frame, bool valid = true);
/// Returns TPDO `number` with the present values.
Frame tpdo_frame(WrongSlave& slave, unsigned number, Packing packing = Packing::right);
/// Writes the values of an RPDO into the dictionary without any check. This triggers no TPDO.
void apply_rpdo(WrongSlave& slave, unsigned number, const Frame& frame);
/// Returns the length that an RPDO must have, in bytes.
std::size_t rpdo_length(WrongSlave& slave, unsigned number);

}  // namespace canproof::test::zoo
