// PDOs as the dictionary of a wrong slave describes them.
#pragma once

#include <optional>

#include "tests/conformance/zoo/sdo_frames.hpp"

namespace canproof::test::zoo {

constexpr unsigned pdo_count = 4;  ///< in each direction
constexpr std::uint16_t rpdo_communication = 0x1400;
constexpr std::uint16_t tpdo_communication = 0x1800;
constexpr std::uint16_t mapping_offset = 0x200;

/// How objects follow each other in a frame.
enum class Packing { right, reversed, bytewise };

/// Sub-index `sub` of the communication parameters of PDO `number` (from 0).
std::uint32_t pdo_parameter(WrongSlave& slave, std::uint16_t communication, unsigned number, std::uint8_t sub);
bool is_valid_pdo(WrongSlave& slave, std::uint16_t communication, unsigned number);
/// The PDO that has the identifier of `frame`; valid PDOs only, or others only.
std::optional<unsigned> pdo_of(WrongSlave& slave, std::uint16_t communication, const Frame& frame, bool valid = true);
/// TPDO `number` with the values of now.
Frame tpdo_frame(WrongSlave& slave, unsigned number, Packing packing = Packing::right);
/// Puts the values of an RPDO into the dictionary without any check. No TPDO notices it.
void apply_rpdo(WrongSlave& slave, unsigned number, const Frame& frame);
/// Bytes that an RPDO must have.
std::size_t rpdo_length(WrongSlave& slave, unsigned number);

}  // namespace canproof::test::zoo
