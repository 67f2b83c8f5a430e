// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/standard_objects.hpp"

#include "host/base/cia301.hpp"

namespace canproof::host {

const std::vector<StandardObject301>& standard_objects_301() {
    using Access = StandardObject301::Access;
    constexpr unsigned u8 = 5;
    constexpr unsigned u16 = 6;
    constexpr unsigned u32 = 7;
    constexpr unsigned text = 9;
    static const std::vector<StandardObject301> all{{cia301::device_type, 7, u32, Access::read},
                                                    {cia301::error_register, 7, u8, Access::read},
                                                    {cia301::manufacturer_status, 7, u32, Access::read},
                                                    {cia301::error_list, 8, u32, Access::read},
                                                    {cia301::sync_cob_id, 7, u32, Access::any},
                                                    {cia301::sync_period, 7, u32, Access::any},
                                                    {cia301::sync_window, 7, u32, Access::any},
                                                    {cia301::device_name, 7, text, Access::read},
                                                    {cia301::hardware_version, 7, text, Access::read},
                                                    {cia301::software_version, 7, text, Access::read},
                                                    {cia301::guard_time, 7, u16, Access::any},
                                                    {cia301::life_time_factor, 7, u8, Access::any},
                                                    {cia301::store_parameters, 8, u32, Access::write},
                                                    {cia301::restore_parameters, 8, u32, Access::write},
                                                    {cia301::time_cob_id, 7, u32, Access::any},
                                                    {cia301::emcy_cob_id, 7, u32, Access::any},
                                                    {cia301::emcy_inhibit_time, 7, u16, Access::any},
                                                    {cia301::consumer_heartbeat_time, 8, u32, Access::any},
                                                    {cia301::producer_heartbeat_time, 7, u16, Access::any},
                                                    {cia301::identity, 9, u32, Access::read},
                                                    {cia301::sync_counter_overflow, 7, u8, Access::any},
                                                    {cia301::error_behaviour, 8, u8, Access::any}};
    return all;
}

}  // namespace canproof::host
