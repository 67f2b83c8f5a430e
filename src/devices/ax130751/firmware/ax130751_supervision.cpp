// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_supervision.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/objects.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;
namespace field = generated::ax130751::field;

/// Returns whether the supply is within the range of the hardware's protection, which cannot be configured. NaN is
/// outside.
static_assert(implements<req::AOR_DIAG_008> && implements<req::AOR_K_SUPPLY_SHUTDOWN_LOW> &&
              implements<req::AOR_K_SUPPLY_SHUTDOWN_HIGH>);
bool is_within_hardware(const float supply) noexcept {
    return (supply >= own::supply_shutdown_low) && (supply <= own::supply_shutdown_high);
}

}  // namespace

static_assert(implements<req::AOR_DIAG_005> && implements<req::AOR_DIAG_011> && implements<req::AOR_DIAG_018>);
void Supervision::advance(const generated::ax130751::Inputs& inputs, ObjectDictionary& objects) noexcept {
    static_assert(implements<req::AOR_DIAG_001>);
    objects.set(field::o5020_power_supply_field_value, inputs.supply);
    objects.set(field::o5030_processor_temperature_field_value, inputs.cpu_temperature);

    const bool watches_supply = objects.get(field::o5021_enable_error_detection_on_power_supply) != 0U;
    const float under = static_cast<float>(objects.get(field::o5022_under_voltage_threshold));
    const float over = static_cast<float>(objects.get(field::o5023_over_voltage_threshold));
    const float hysteresis = static_cast<float>(objects.get(field::o5024_hysteresis_to_clear_supply_fault));
    static_assert(implements<req::AOR_DIAG_002> && implements<req::AOR_DIAG_015>);
    const bool low = under_.advance(watches_supply, inputs.supply < under, inputs.supply >= (under + hysteresis));
    static_assert(implements<req::AOR_DIAG_003> && implements<req::AOR_DIAG_016>);
    const bool high = over_.advance(watches_supply, inputs.supply > over, inputs.supply <= (over - hysteresis));

    const bool watches_heat = objects.get(field::o5031_enable_error_detection_on_temperature) != 0U;
    const float hottest = static_cast<float>(objects.get(field::o5032_over_temperature_threshold));
    const float cooling = static_cast<float>(objects.get(field::o5033_hysteresis_to_clear_temperature_fault));
    static_assert(implements<req::AOR_DIAG_004> && implements<req::AOR_DIAG_017>);
    const float heat = inputs.cpu_temperature;
    const bool hot =
        temperature_.advance(watches_heat, std::isnan(heat) || (heat > hottest), heat <= (hottest - cooling));

    const bool supply_shuts = objects.get(field::o5025_enable_power_supply_fault_disables_outputs) != 0U;
    const bool heat_shuts = objects.get(field::o5034_enable_temperature_fault_shutdown) != 0U;
    powered_ = is_within_hardware(inputs.supply);
    static_assert(implements<req::AOR_DIAG_022>);
    protects_ = watches_supply && (!powered_);
    static_assert(implements<req::AOR_DIAG_006>);
    static_assert(implements<req::AOR_DIAG_014>);
    shutdown_ = (!powered_) || ((low || high) && supply_shuts) || (hot && heat_shuts);
}

}  // namespace canproof::ax130751
