# SPDX-License-Identifier: Apache-2.0
# Headers of the standard library and of other libraries that most files of the host include. They are precompiled once for each
# build. No header of this project is among them, because each change of it would recompile everything. Each file must still include
# everything that it uses; a build with -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON checks this.
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

# canproof_precompiled(TARGET...): starts each file of these targets with the precompiled headers. The targets must have the
# project's flags and link fmt. Does nothing in a project that uses the installed package, because it has too few files.
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
