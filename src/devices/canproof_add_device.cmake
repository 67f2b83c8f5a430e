# SPDX-License-Identifier: Apache-2.0
# canproof_add_device(NAME) adds the device of the calling folder to every target that is built from devices.
#   firmware/    the library canproof_NAME_firmware
#   simulation/  the library canproof_NAME_simulation, and an entry of the catalogue
#   target/      its images for the microcontroller (preset target)
# If a part is missing, the configure step stops (device_parts.cmake).
include(${CMAKE_CURRENT_LIST_DIR}/device_parts.cmake)

function(canproof_add_device name)
  string(REPLACE "-" "_" word ${name})
  canproof_check_device(${CANPROOF_ROOT} ${name})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS target/budgets.toml)
  file(GLOB_RECURSE firmware CONFIGURE_DEPENDS firmware/*.cpp)
  canproof_check_written_parameters(${firmware})
  canproof_firmware_library(canproof_${word}_firmware SOURCES ${firmware} LINKS canproof_firmware)
  if(CMAKE_SYSTEM_NAME STREQUAL Generic)
    canproof_device_images(${name} ${word})
  else()
    canproof_device_simulation(${word})
  endif()
  set_property(GLOBAL APPEND PROPERTY CANPROOF_DEVICES ${name})
endfunction()

# Enables -Wswitch-enum for each source with a switch over `Parameter` of generated/NAME/written.hpp (the parameters that a write can change).
# The switch must then have a label for each parameter, so a new object in the requirements register stops the build until the switch names it.
function(canproof_check_written_parameters)
  foreach(source ${ARGN})
    file(STRINGS ${source} labels REGEX "case (own::)?Parameter::")
    if(labels)
      set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -Wswitch-enum)
    endif()
  endforeach()
endfunction()

function(canproof_device_simulation word)
  file(GLOB_RECURSE simulation CONFIGURE_DEPENDS simulation/*.cpp)
  add_library(canproof_${word}_simulation STATIC ${simulation})
  target_link_libraries(canproof_${word}_simulation PUBLIC canproof_${word}_firmware canproof_device_model)
  target_compile_options(canproof_${word}_simulation PRIVATE ${CANPROOF_FUZZED_FLAGS})
  if(NOT CANPROOF_FUZZED_FLAGS)
    canproof_precompiled(canproof_${word}_simulation)
  endif()
endfunction()

# Writes BUILD/devices.txt for scripts: one line per device with its name, its C++ name and its folder, separated by
# tabs.
function(canproof_list_devices)
  get_property(devices GLOBAL PROPERTY CANPROOF_DEVICES)
  set(lines "")
  foreach(name ${devices})
    string(REPLACE "-" "_" word ${name})
    string(APPEND lines "${name}\t${word}\t${CANPROOF_ROOT}/src/devices/${name}\n")
  endforeach()
  file(WRITE ${CMAKE_BINARY_DIR}/devices.txt "${lines}")
endfunction()

# Adds the library canproof_devices: the generated list of all devices.
function(canproof_write_catalogue)
  get_property(devices GLOBAL PROPERTY CANPROOF_DEVICES)
  set(declarations "")
  set(rows "")
  set(libraries "")
  foreach(name ${devices})
    string(REPLACE "-" "_" word ${name})
    string(APPEND declarations "namespace canproof::${word} {\nconst host::DeviceModel& model();\n}\n")
    string(APPEND rows "        {\"${name}\", &${word}::model()},\n")
    list(APPEND libraries canproof_${word}_simulation)
  endforeach()
  configure_file(catalogue.cpp.in ${generated_dir}/catalogue.cpp @ONLY)
  add_library(canproof_devices STATIC catalogue.cpp ${generated_dir}/catalogue.cpp)
  target_link_libraries(canproof_devices PUBLIC ${libraries})
endfunction()
