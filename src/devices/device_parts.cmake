# SPDX-License-Identifier: Apache-2.0
# Checks the parts of a device. canproof_add_device() calls it; to run it without a build:
#   cmake -DROOT=. -DNAME=ax188001 -P src/devices/device_parts.cmake

# canproof_check_device(ROOT NAME) stops when a part of the device is missing, and names it.
function(canproof_check_device root name)
  string(REPLACE "-" "_" word ${name})
  set(device src/devices/${name})
  canproof_device_part("spec/devices/${name}/device.toml" "1" "its register")
  canproof_device_part("${device}/firmware/*.cpp" "2" "its firmware")
  canproof_device_part("${device}/simulation/model.cpp" "3" "its line of the catalogue")
  canproof_device_part("${device}/simulation/panel.json" "3" "its card on the panel")
  canproof_device_part("${device}/target/main.cpp" "4" "its image for the microcontroller")
  canproof_device_part("${device}/target/budgets.toml" "4" "its bounds of memory and time")
  foreach(key flash ram stack host_stack tick)
    canproof_device_budget("${device}/target/budgets.toml" ${key})
  endforeach()
  canproof_device_part("tests/devices/${name}/*_test.cpp" "5" "its tests")
  canproof_device_part("properties/devices/${name}/*_property.cpp" "6" "its properties")
  canproof_device_part("fuzz/devices/${name}/${word}_fuzz.cpp" "7" "its fuzz target")
  canproof_device_part("fuzz/devices/${name}/corpus/${word}/*" "7" "the seeds of its fuzz target")
endfunction()

# Stops when no file of the device `name` below `root` has this path.
function(canproof_device_part path step meaning)
  file(GLOB_RECURSE found ${root}/${path})
  if(NOT found)
    message(FATAL_ERROR "device ${name} has no ${path} (${meaning}): see step ${step} of \"Add a device\" in src/devices/README.md")
  endif()
endfunction()

# Stops when a line `key = ...` is missing.
function(canproof_device_budget path key)
  file(STRINGS ${root}/${path} found REGEX "^${key} = ")
  if(NOT found)
    message(FATAL_ERROR "device ${name} has no \"${key}\" in ${path}: see step 4 of \"Add a device\" in src/devices/README.md")
  endif()
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  get_filename_component(ROOT ${ROOT} ABSOLUTE)
  canproof_check_device(${ROOT} ${NAME})
endif()
