# SPDX-License-Identifier: Apache-2.0
# `cmake --install` installs the program and, below lib/canproof, what an outside project builds its devices from
# (find_package, canproofConfig.cmake). These are sources of the firmware, of the test benches and of the fuzz targets'
# support, and headers and compiled libraries of the host.
set(home lib/canproof)
install(TARGETS canproof DESTINATION bin)
if(TARGET canproof-prove)
  install(TARGETS canproof-prove DESTINATION bin)  # `canproof prove` starts it from the folder that contains `canproof`
endif()
install(TARGETS speccompiler canproof_base canproof_register canproof_datasheet canproof_codegen canproof_sim
                canproof_report canproof_selection canproof_conform canproof_assess canproof_http canproof_app
        RUNTIME DESTINATION ${home}/prebuilt ARCHIVE DESTINATION ${home}/prebuilt)
install(FILES CMakeLists.txt LICENSE DESTINATION ${home})
install(DIRECTORY src/firmware src/target DESTINATION ${home}/src USE_SOURCE_PERMISSIONS)
install(DIRECTORY src/host DESTINATION ${home}/src USE_SOURCE_PERMISSIONS
        FILES_MATCHING PATTERN CMakeLists.txt PATTERN *.cmake PATTERN *.hpp PATTERN main.cpp PATTERN ccache_launcher REGEX "/panel/page/[^/]*$")
# Sources of the host that an image of tests for the microcontroller compiles.
foreach(file base/time_text codegen/dictionary_rows sim/bus/candump sim/bus/frame_text sim/devices/generic_device sim/devices/memory)
  get_filename_component(folder ${file} DIRECTORY)
  install(FILES src/host/${file}.cpp DESTINATION ${home}/src/host/${folder})
endforeach()
file(GLOB device_files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} src/devices/*.* src/*.cmake)
foreach(file ${device_files})
  get_filename_component(folder ${file} DIRECTORY)
  install(FILES ${file} DESTINATION ${home}/${folder})
endforeach()
install(DIRECTORY misra DESTINATION ${home} USE_SOURCE_PERMISSIONS
        PATTERN reviews.toml EXCLUDE PATTERN "*_check" EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY spec/canopen DESTINATION ${home}/spec)
install(FILES tests/CMakeLists.txt DESTINATION ${home}/tests)
install(DIRECTORY tests/support DESTINATION ${home}/tests)
install(FILES tests/bench/frame_cost_main.cpp DESTINATION ${home}/tests/bench)
install(FILES tests/mutation/main.cpp DESTINATION ${home}/tests/mutation)
install(DIRECTORY tests/mutation/code DESTINATION ${home}/tests/mutation USE_SOURCE_PERMISSIONS
        FILES_MATCHING PATTERN CMakeLists.txt PATTERN *.py PATTERN *.hpp PATTERN *.cpp PATTERN example EXCLUDE)
install(PROGRAMS tests/coverage DESTINATION ${home}/tests)
install(FILES properties/CMakeLists.txt DESTINATION ${home}/properties)
install(DIRECTORY properties/support DESTINATION ${home}/properties)
file(GLOB invariant_files properties/invariants/*.*)
install(FILES ${invariant_files} DESTINATION ${home}/properties/invariants)
install(FILES fuzz/CMakeLists.txt fuzz/targets.sh DESTINATION ${home}/fuzz)
install(DIRECTORY fuzz/support DESTINATION ${home}/fuzz)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/package/canproofConfig.cmake
     CONTENT [[include(${CMAKE_CURRENT_LIST_DIR}/../../canproof/src/canproofConfig.cmake)
]] @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/package/canproofConfig.cmake DESTINATION lib/cmake/canproof)

# Manual pages and completions, as the program itself prints them.
install(CODE "set(program \"$<TARGET_FILE:canproof>\")
set(words \"${CMAKE_BINARY_DIR}/package/words\")")
install(CODE [[
file(REMOVE_RECURSE ${words})
file(MAKE_DIRECTORY ${words}/man)
execute_process(COMMAND ${program} manual --out ${words}/man COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages ${words}/man/*.1)
execute_process(COMMAND gzip -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
foreach(shell bash zsh fish)
  execute_process(COMMAND ${program} completion ${shell} OUTPUT_FILE ${words}/${shell} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set(share ${CMAKE_INSTALL_PREFIX}/share)
file(INSTALL ${words}/man/ DESTINATION ${share}/man/man1)
file(INSTALL ${words}/bash DESTINATION ${share}/bash-completion/completions RENAME canproof)
file(INSTALL ${words}/zsh DESTINATION ${share}/zsh/vendor-completions RENAME _canproof)
file(INSTALL ${words}/fish DESTINATION ${share}/fish/vendor_completions.d RENAME canproof.fish)
]])

# The Debian package (`cpack` in the build of the preset release).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "canproof maintainers <maintainers@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "CANopen devices from requirements: program, firmware, tests and fuzz world")
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Packages that ./run and ./test of a new device need; those of mutate, coverage, misra, fuzz and target are recommended.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++, cmake (>= 3.25), ninja-build, libtomlplusplus-dev, nlohmann-json3-dev, libpugixml-dev, libcli11-dev, libfmt-dev, libssl-dev, libsocketcan-dev, libgtest-dev, libgmock-dev, librapidcheck-dev")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "clang-19, libclang-rt-19-dev, llvm-19, python3, python3-clang-19, clang-tidy-19, clang-tools-19, cppcheck, ccache, googletest, gcc-arm-none-eabi, libnewlib-arm-none-eabi, libstdc++-arm-none-eabi-newlib, qemu-system-arm")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
include(CPack)
