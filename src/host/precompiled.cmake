# SPDX-License-Identifier: Apache-2.0
# Headers of the standard library and of other libraries that most files of the host include, precompiled once per build. None
# belongs to this project, because its change would recompile everything. Each file still includes everything that it uses: see
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "// Carries the precompiled headers.\n")
add_library(canproof_precompiled_headers OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/precompiled.cpp)
target_link_libraries(canproof_precompiled_headers PRIVATE canproof_options fmt::fmt)
target_precompile_headers(canproof_precompiled_headers PRIVATE
  <algorithm> <array> <cmath> <cstdint> <deque> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <sstream>
  <string> <variant> <vector> <fmt/format.h> <fmt/ranges.h>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(canproof_precompiled_options -fpch-preprocess)  # lets ccache detect the precompiled header of a file
else()
  set(canproof_precompiled_options "SHELL:-Xclang -fno-pch-timestamp")  # the same headers give the same bytes
endif()
target_compile_options(canproof_precompiled_headers PRIVATE ${canproof_precompiled_options})

# canproof_precompiled(TARGET...): starts each file of these targets with those headers. The targets have the project's flags and
# link fmt. A project on the installed package has too few files to profit from precompiled headers.
function(canproof_precompiled)
  if(CANPROOF_PREBUILT)
    return()
  endif()
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE ${canproof_precompiled_options})
    target_precompile_headers(${target} REUSE_FROM canproof_precompiled_headers)
  endforeach()
endfunction()

# canproof_precompile(TARGET HEADER...): precompiles further headers for TARGET.
function(canproof_precompile target)
  if(CANPROOF_PREBUILT)
    return()
  endif()
  target_compile_options(${target} PRIVATE ${canproof_precompiled_options})
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()
