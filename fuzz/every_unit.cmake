# SPDX-License-Identifier: Apache-2.0
# Writes generated/every_unit.hpp: the devices of fuzz/bus_fuzz.cpp as a type, in the order of `bus_node` in their _unit.hpp. Stops when a
# device has no `bus_node`, or when two devices have the same one.
function(canproof_write_every_unit)
  get_property(devices GLOBAL PROPERTY CANPROOF_DEVICES)
  set(seats "")
  foreach(device ${devices})
    string(REPLACE "-" "_" word ${device})
    set(header fuzz/devices/${device}/${word}_unit.hpp)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CANPROOF_ROOT}/${header})
    file(STRINGS ${CANPROOF_ROOT}/${header} node REGEX " bus_node = [0-9]+")
    if(NOT node MATCHES "bus_node = ([0-9]+)")
      message(FATAL_ERROR "device ${device} has no bus_node in ${header}: see step 7 of \"Add a device\" in src/devices/README.md")
    endif()
    set(seat ${CMAKE_MATCH_1})
    if(DEFINED device_at_${seat})
      message(FATAL_ERROR "device ${device} has no bus_node of its own in ${header} (${seat} is that of ${device_at_${seat}}): "
                          "see step 7 of \"Add a device\" in src/devices/README.md")
    endif()
    set(device_at_${seat} ${device})
    list(APPEND seats "${seat}|${header}|${word}")
  endforeach()
  list(SORT seats COMPARE NATURAL)
  set(includes "")
  set(units "")
  foreach(seat ${seats})
    string(REPLACE "|" ";" seat ${seat})
    list(GET seat 1 header)
    list(GET seat 2 word)
    string(APPEND includes "#include \"${header}\"\n")
    set(unit "")
    string(REPLACE "_" ";" parts ${word})
    foreach(part ${parts})
      string(SUBSTRING ${part} 0 1 first)
      string(SUBSTRING ${part} 1 -1 rest)
      string(TOUPPER ${first} first)
      string(APPEND unit ${first}${rest})
    endforeach()
    list(APPEND units ${unit}Unit)
  endforeach()
  list(JOIN units ", " units)
  file(CONFIGURE OUTPUT ${generated_dir}/generated/every_unit.hpp @ONLY CONTENT
"// Written by fuzz/every_unit.cmake from the headers that it includes.
#pragma once

#include <tuple>

${includes}
namespace canproof::fuzz {
using EveryUnit = std::tuple<${units}>;
}
")
endfunction()
