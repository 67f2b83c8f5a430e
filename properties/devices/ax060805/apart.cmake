# SPDX-License-Identifier: Apache-2.0
# Each of these sources uses a name that another source of the folder uses for something else. canproof_join(), which
# compiles several sources as one, compiles each of these by itself.
set(apart inclinometer_cache_property.cpp inclinometer_device_property.cpp inclinometer_filters_property.cpp inclinometer_model_property.cpp inclinometer_swap_property.cpp reset_property.cpp tilt_property.cpp)
