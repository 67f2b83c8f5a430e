// SPDX-License-Identifier: Apache-2.0
// The main loop of a device is a template that only tests and images instantiate. It is instantiated here, so that the
// program of mutants contains it together with its mutants.
#include "tests/support/stm32f405/small_devices.hpp"

namespace canproof::stm32f405 {

template class DeviceLoop<cbx_ao412::Device, test::TestBoard>;
template class DeviceLoop<test::ChangingDevice, test::TestBoard>;
template class DeviceLoop<test::RecordingDevice, test::TestBoard>;

}  // namespace canproof::stm32f405
