// SPDX-License-Identifier: Apache-2.0
// Indices of the object dictionary in CiA 301 and CiA 302: the limits of its areas, and the communication objects. Host
// code uses these constants instead of numbers (tests/indices_check checks this). A constant has the same name as its
// object in spec/canopen/objects.toml, if that file lists the object.
#pragma once

#include <cstdint>

namespace canproof::host::cia301 {

inline constexpr std::uint16_t first_object = 0x1000;  ///< lower indices are data types
inline constexpr std::uint16_t last_communication_object = 0x1FFF;
inline constexpr std::uint16_t first_manufacturer_object = 0x2000;
inline constexpr std::uint16_t last_manufacturer_object = 0x5FFF;
inline constexpr std::uint16_t first_reserved_index = 0xC000;

inline constexpr std::uint16_t device_type = 0x1000;
inline constexpr std::uint16_t error_register = 0x1001;
inline constexpr std::uint16_t manufacturer_status = 0x1002;
inline constexpr std::uint16_t error_list = 0x1003;
inline constexpr std::uint16_t sync_cob_id = 0x1005;
inline constexpr std::uint16_t sync_period = 0x1006;
inline constexpr std::uint16_t sync_window = 0x1007;
inline constexpr std::uint16_t device_name = 0x1008;
inline constexpr std::uint16_t hardware_version = 0x1009;
inline constexpr std::uint16_t software_version = 0x100A;
inline constexpr std::uint16_t guard_time = 0x100C;
inline constexpr std::uint16_t life_time_factor = 0x100D;
inline constexpr std::uint16_t guarding_identifier = 0x100E;
inline constexpr std::uint16_t store_parameters = 0x1010;
inline constexpr std::uint16_t restore_parameters = 0x1011;
inline constexpr std::uint16_t time_cob_id = 0x1012;
inline constexpr std::uint16_t emcy_cob_id = 0x1014;
inline constexpr std::uint16_t emcy_inhibit_time = 0x1015;
inline constexpr std::uint16_t consumer_heartbeat_time = 0x1016;
inline constexpr std::uint16_t producer_heartbeat_time = 0x1017;
inline constexpr std::uint16_t identity = 0x1018;
inline constexpr std::uint16_t sync_counter_overflow = 0x1019;
inline constexpr std::uint16_t verify_configuration = 0x1020;
inline constexpr std::uint16_t emcy_consumers = 0x1028;
inline constexpr std::uint16_t error_behaviour = 0x1029;

// Families of objects of one kind: the index of the first object and of the last one.
inline constexpr std::uint16_t sdo_server_parameter = 0x1200;
inline constexpr std::uint16_t last_sdo_server_parameter = 0x127F;
inline constexpr std::uint16_t sdo_client_parameter = 0x1280;
inline constexpr std::uint16_t last_sdo_client_parameter = 0x12FF;
inline constexpr std::uint16_t rpdo_communication = 0x1400;
inline constexpr std::uint16_t last_rpdo_communication = 0x15FF;
inline constexpr std::uint16_t rpdo_mapping = 0x1600;
inline constexpr std::uint16_t last_rpdo_mapping = 0x17FF;
inline constexpr std::uint16_t tpdo_communication = 0x1800;
inline constexpr std::uint16_t last_tpdo_communication = 0x19FF;
inline constexpr std::uint16_t tpdo_mapping = 0x1A00;
inline constexpr std::uint16_t last_tpdo_mapping = 0x1BFF;

// CiA 302-2 and 302-3.
inline constexpr std::uint16_t program_data = 0x1F50;
inline constexpr std::uint16_t nmt_startup = 0x1F80;
inline constexpr std::uint16_t self_starting_nodes = 0x1F91;

/// Returns whether the index is in the manufacturer-specific area.
constexpr bool is_of_manufacturer(unsigned index) {
    return index >= first_manufacturer_object && index <= last_manufacturer_object;
}

/// Returns whether the index is that of a PDO's communication parameter.
constexpr bool is_pdo_communication(unsigned index) {
    return (index >= rpdo_communication && index <= last_rpdo_communication) ||
           (index >= tpdo_communication && index <= last_tpdo_communication);
}

/// Returns whether the index is that of a PDO's mapping parameter.
constexpr bool is_pdo_mapping(unsigned index) {
    return (index >= rpdo_mapping && index <= last_rpdo_mapping) ||
           (index >= tpdo_mapping && index <= last_tpdo_mapping);
}

}  // namespace canproof::host::cia301
