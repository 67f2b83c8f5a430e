# SPDX-License-Identifier: Apache-2.0
# Each of these sources uses a name that another source in this folder uses for something else. canproof_join() compiles
# other sources together as one, but each of these by itself.
set(apart inclinometer_cache_property.cpp inclinometer_device_property.cpp inclinometer_filters_property.cpp inclinometer_model_property.cpp inclinometer_swap_property.cpp reset_property.cpp tilt_property.cpp)
