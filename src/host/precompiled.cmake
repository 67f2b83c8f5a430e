# Headers of the standard library and of others that most files of the host include, compiled once a build. No header of
# ours: a change of one would compile everything again. Each file still includes what it uses: see -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "// Carries the precompiled headers.\n")
add_library(canproof_precompiled_headers OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/precompiled.cpp)
target_link_libraries(canproof_precompiled_headers PRIVATE canproof_options fmt::fmt)
target_precompile_headers(canproof_precompiled_headers PRIVATE
  <algorithm> <array> <cmath> <cstdint> <deque> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <sstream>
  <string> <variant> <vector> <fmt/format.h> <fmt/ranges.h>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(canproof_precompiled_options -fpch-preprocess)  # ccache then reads which precompiled header a file uses
else()
  set(canproof_precompiled_options "SHELL:-Xclang -fno-pch-timestamp")  # the same headers make the same bytes
endif()
target_compile_options(canproof_precompiled_headers PRIVATE ${canproof_precompiled_options})

# An outside project on the installed package has too few files for precompiled headers to pay.
# canproof_precompiled(TARGET...): compiled as everything of ours, with fmt, these targets begin with those headers.
function(canproof_precompiled)
  if(CANPROOF_PREBUILT)
    return()
  endif()
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE ${canproof_precompiled_options})
    target_precompile_headers(${target} REUSE_FROM canproof_precompiled_headers)
  endforeach()
endfunction()

# canproof_precompile(TARGET HEADER...): headers of TARGET's own beside those.
function(canproof_precompile target)
  if(CANPROOF_PREBUILT)
    return()
  endif()
  target_compile_options(${target} PRIVATE ${canproof_precompiled_options})
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()
