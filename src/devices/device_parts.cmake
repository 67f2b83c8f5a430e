# SPDX-License-Identifier: Apache-2.0
# Checks the parts of a device. canproof_add_device() calls it; to run it without a build:
#   cmake -DROOT=. -DNAME=ax188001 -P src/devices/device_parts.cmake

# canproof_check_device(ROOT NAME) stops when a part of the device is missing, and names it.
function(canproof_check_device root name)
  string(REPLACE "-" "_" word ${name})
  set(device src/devices/${name})
  canproof_device_part("spec/manuals/${name}.toml" "1" "the sections of its manual")
  canproof_device_part("spec/devices/${name}/device.toml" "1" "its identity")
  canproof_device_part("spec/devices/${name}/objects/*.toml" "1" "its object dictionary")
  canproof_device_part("spec/devices/${name}/behaviour/*.toml" "1" "its requirements")
  canproof_device_part("spec/devices/${name}/decisions.toml" "1" "its decisions" "spec/devices/${name}/decisions/*.toml")
  canproof_device_part("${device}/firmware/${word}.hpp" "2" "its class")
  canproof_device_part("${device}/firmware/${word}.cpp" "2" "its firmware")
  canproof_device_part("${device}/simulation/simulation.cpp" "3" "its simulation")
  canproof_device_part("${device}/simulation/model.cpp" "3" "its line of the catalogue")
  canproof_device_part("${device}/simulation/panel.json" "3" "its card on the panel")
  canproof_device_part("${device}/target/main.cpp" "4" "its image for the microcontroller")
  canproof_device_part("${device}/target/budgets.toml" "4" "its bounds of memory and time")
  foreach(key flash ram stack host_stack tick)
    canproof_device_budget("${device}/target/budgets.toml" ${key})
  endforeach()
  canproof_device_part("tests/devices/${name}/*bench.hpp" "5" "the bench of its tests")
  canproof_device_part("tests/devices/${name}/*_test.cpp" "5" "its tests")
  canproof_device_part("properties/devices/${name}/*_property.cpp" "6" "its properties")
  canproof_device_part("fuzz/devices/${name}/${word}_unit.hpp" "7" "the limits that hold while it is fuzzed")
  canproof_device_part("fuzz/devices/${name}/${word}_fuzz.cpp" "7" "its fuzz target")
  canproof_device_part("fuzz/devices/${name}/${word}.dict" "7" "the dictionary of its fuzz target")
  canproof_device_part("fuzz/devices/${name}/${word}.options" "7" "the options of its fuzz target")
  canproof_device_part("fuzz/devices/${name}/corpus/${word}/*" "7" "the seeds of its fuzz target")
  if(EXISTS ${root}/src/devices/README.md)  # the pages of this repository; an outside project has none
    canproof_device_rows("README.md" 1)
    canproof_device_rows("src/target/README.md" 5)
  endif()
endfunction()

# Stops unless a file of the device `name` below `root` has this path or one of the further paths.
function(canproof_device_part path step meaning)
  list(TRANSFORM ARGN PREPEND ${root}/ OUTPUT_VARIABLE others)
  file(GLOB_RECURSE found ${root}/${path} ${others})
  if(NOT found)
    message(FATAL_ERROR "device ${name} has no ${path} (${meaning}): see step ${step} of \"Add a device\" in src/devices/README.md")
  endif()
endfunction()

# Stops when fewer than `least` rows of the tables on `page` begin with the name of the device.
function(canproof_device_rows page least)
  file(STRINGS ${root}/${page} found REGEX "^\\| `${name}` \\|")
  list(LENGTH found rows)
  if(rows LESS least)
    message(FATAL_ERROR "device ${name} has no row in a table of ${page} (${rows} of ${least}): "
                        "run tests/program/readme_devices.py --write-readme: see step 8 of \"Add a device\" in src/devices/README.md")
  endif()
endfunction()

# Stops when the budgets file `path` has no line `key = ...`.
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
