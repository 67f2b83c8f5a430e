# SPDX-License-Identifier: Apache-2.0
# canproof_flashed_object(NAME WORD OPTION…) adds the object library flashed_WORD: target/device.cpp of a device, and the function
# flashed_WORD() of flashed_bench.hpp, which returns its entry points. -fno-access-control lets it name the private members of the image.
function(canproof_flashed_object name word)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/flashed/${word}.cpp)
  configure_file(${canproof_SOURCE_DIR}/tests/support/stm32f405/flashed_device.cpp.in ${source} @ONLY)
  add_library(flashed_${word} OBJECT ${source})
  target_link_libraries(flashed_${word} PUBLIC canproof_${word}_firmware canproof_stm32f405)
  target_include_directories(flashed_${word} PRIVATE ${canproof_SOURCE_DIR})
  target_compile_options(flashed_${word} PRIVATE -fno-access-control ${ARGN})
endfunction()
