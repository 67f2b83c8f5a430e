# SPDX-License-Identifier: Apache-2.0
# find_package(canproof): how an outside project gets its devices built, tested and proven as those of this one are.
#
#   project(my_device LANGUAGES CXX)
#   find_package(canproof REQUIRED)
#   canproof_project()
#
# Its folders are those of this project: spec/, src/devices/NAME/, tests/, properties/, fuzz/. The same file serves the
# installed package (share/canproof) and a checkout (-Dcanproof_DIR=CHECKOUT/src): the package has the host's libraries
# compiled, a checkout compiles them in the outside build.
get_filename_component(CANPROOF_HOME ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(CANPROOF_PREBUILT "" CACHE PATH "Compiled libraries of the host; from the package when empty")
if(NOT CANPROOF_PREBUILT AND EXISTS ${CANPROOF_HOME}/prebuilt/speccompiler)
  set(CANPROOF_PREBUILT ${CANPROOF_HOME}/prebuilt)
endif()

# Builds what is in this folder. Its presets' variables are those of canproof's own presets: CANPROOF_MUTATION,
# CANPROOF_FUZZER, CANPROOF_COVERAGE.
macro(canproof_project)
  set(CANPROOF_ROOT ${CMAKE_CURRENT_SOURCE_DIR})
  enable_testing()
  add_subdirectory(${CANPROOF_HOME} package)
endmacro()
