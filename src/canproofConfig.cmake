# SPDX-License-Identifier: Apache-2.0
# find_package(canproof): how an outside project uses canproof.
#
# With these lines, the devices of an outside project are built, tested and proven like those of this project:
#
#   project(my_device LANGUAGES CXX)
#   find_package(canproof REQUIRED)
#   canproof_project()
#
# The outside project has the same folders as this project: spec/, src/devices/NAME/, tests/, properties/, fuzz/.
#
# With these lines, an outside project uses only the shared firmware, also for another processor with its own toolchain
# file:
#
#   find_package(canproof REQUIRED)
#   target_link_libraries(my_firmware PRIVATE canproof::canopen)
#
# canproof::base has the time, bytes and checksums, canproof::canopen the node with its services, canproof::blocks the blocks of
# several devices. They are compiled from their sources with the project's compiler and flags.
#
# This file serves both the installed package (lib/canproof) and a checkout (-Dcanproof_DIR=CHECKOUT/src): the package
# contains the compiled libraries of the host and the generator of tables (speccompiler). With a checkout,
# canproof_project() compiles both in the outside build, and the shared firmware alone needs
# -DCANPROOF_SPECCOMPILER=CHECKOUT/build/PRESET/speccompiler.
get_filename_component(CANPROOF_HOME ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(CANPROOF_PREBUILT "" CACHE PATH "Compiled libraries of the host; from the package when empty")
if(NOT CANPROOF_PREBUILT AND EXISTS ${CANPROOF_HOME}/prebuilt/speccompiler)
  set(CANPROOF_PREBUILT ${CANPROOF_HOME}/prebuilt)
endif()

# Builds the project in this folder. The presets of the project set the same variables as canproof's own presets:
# CANPROOF_MUTATION, CANPROOF_FUZZER, CANPROOF_COVERAGE.
macro(canproof_project)
  set(CANPROOF_ROOT ${CMAKE_CURRENT_SOURCE_DIR})
  enable_testing()
  add_subdirectory(${CANPROOF_HOME} package)
endmacro()

# Adds the libraries of the shared firmware where canproof_project() has not. Their tables come from the register in spec/canopen.
function(canproof_add_firmware)
  if(TARGET canproof_firmware_base)
    return()
  endif()
  set(CANPROOF_SPECCOMPILER "" CACHE FILEPATH "The compiler of the register; from the package when empty")
  set(compiler ${CANPROOF_SPECCOMPILER})
  if(NOT compiler)
    set(compiler ${CANPROOF_PREBUILT}/speccompiler)
  endif()
  if(NOT EXISTS ${compiler})
    message(FATAL_ERROR "no compiler of the register: build the target speccompiler in a checkout of canproof, "
                        "and name it by -DCANPROOF_SPECCOMPILER=FILE")
  endif()
  set(generated_dir ${CMAKE_BINARY_DIR}/canproof/generated)
  file(GLOB spec_files CONFIGURE_DEPENDS ${CANPROOF_HOME}/spec/canopen/*.toml)
  set(headers ${generated_dir}/generated/canopen/requirements.hpp)
  add_custom_command(
    OUTPUT ${headers}
    COMMAND ${compiler} --package ${CANPROOF_HOME}/spec --out ${generated_dir}/generated
    COMMAND ${CMAKE_COMMAND} -E touch ${headers}
    DEPENDS ${compiler} ${spec_files}
    COMMENT "Compiling the tables of the shared firmware"
    VERBATIM)
  add_custom_target(generated DEPENDS ${headers})
  add_library(canproof_options INTERFACE)
  target_include_directories(canproof_options INTERFACE ${CANPROOF_HOME}/src)
  target_compile_features(canproof_options INTERFACE cxx_std_17)
  # add_subdirectory() is not possible at the end of a folder, so the file is included
  include(${CANPROOF_HOME}/src/firmware/CMakeLists.txt)
endfunction()

# Defines the names of the libraries now, so that targets can use them. canproof_project(), or the end of this folder,
# adds what they contain.
foreach(layer base canopen blocks)
  if(NOT TARGET canproof::${layer})
    add_library(canproof::${layer} INTERFACE IMPORTED)
    target_link_libraries(canproof::${layer} INTERFACE canproof_firmware_${layer})
  endif()
endforeach()
cmake_language(DEFER CALL canproof_add_firmware)
