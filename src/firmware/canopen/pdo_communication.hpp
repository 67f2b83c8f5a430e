// What receive and transmit PDOs share: the communication parameters 14xxh and 18xxh, and the order in which a PDO is
// re-mapped (CiA 301, 7.5.2.35 to 7.5.2.38).
#pragma once

#include <array>

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof {

enum class PdoDirection : std::uint8_t { receive, transmit };

/// PDO1…PDO8 of each direction: 1400h…1407h, 1800h…1807h. The devices here have at most four.
constexpr std::size_t max_pdos = 8U;

/// When a received PDO takes effect and when a transmit PDO is sent, by its transmission type.
using PdoApplied = generated::canopen::t_co_t_transmission_type::Applied;
using PdoSent = generated::canopen::t_co_t_transmission_type::Sent;

/// One communication parameter object, read once after each change.
struct PdoParameters {
    std::uint32_t identifier{0U};
    bool valid{false};           ///< bit 31 of the COB-ID is clear
    bool remote_allowed{false};  ///< bit 30 of the COB-ID is clear
    std::uint8_t type{0U};
    std::uint8_t sync_start{0U};  ///< counter value of the SYNC that is the first; zero: any
    PdoApplied applied{PdoApplied::refused};
    PdoSent sent{PdoSent::refused};
    Duration inhibit{};  ///< least time between two transmissions
    Duration event{};    ///< longest time between two transmissions or receptions; zero: no limit
};

/// Object of PDO `number` (0…max_pdos - 1).
constexpr std::uint16_t communication_object(const PdoDirection direction, const std::size_t number) noexcept {
    constexpr std::uint32_t first_receive{0x1400U};
    constexpr std::uint32_t first_transmit{0x1800U};
    return static_cast<std::uint16_t>(((direction == PdoDirection::receive) ? first_receive : first_transmit) + number);
}
constexpr std::uint16_t mapping_object(const PdoDirection direction, const std::size_t number) noexcept {
    constexpr std::uint32_t between{0x0200U};
    return static_cast<std::uint16_t>(communication_object(direction, number) + between);
}

/// How many of the PDOs of a direction the dictionary can have: the highest number present.
constexpr std::size_t count_pdos(const DictionaryTables& tables, const PdoDirection direction) noexcept {
    std::size_t count{0U};
    for (const ObjectRow& object : tables.objects) {
        for (std::size_t number = count; number < max_pdos; ++number) {
            count = (std::uint32_t{object.index} == communication_object(direction, number)) ? (number + 1U) : count;
        }
    }
    return count;
}
PdoParameters read_pdo_parameters(const ObjectDictionary& objects, PdoDirection direction, std::size_t number) noexcept;

/// Whether an entry of 14xxh, 16xxh, 18xxh or 1Axxh may get this value now.
AbortCode check_pdo_write(const ObjectDictionary& objects, const EntryRef& entry, ByteView value) noexcept;

/// Number of the PDO of `direction` to which an object of the communication area belongs; max_pdos when to none.
std::size_t pdo_number(PdoDirection direction, std::uint16_t index) noexcept;

}  // namespace canproof
