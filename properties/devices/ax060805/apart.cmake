# SPDX-License-Identifier: Apache-2.0
# Each of these sources names something as another one of its folder does: canproof_join() compiles it by itself.
set(apart inclinometer_cache_property.cpp inclinometer_device_property.cpp inclinometer_filters_property.cpp inclinometer_model_property.cpp inclinometer_swap_property.cpp reset_property.cpp tilt_property.cpp)
