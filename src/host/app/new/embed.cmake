# SPDX-License-Identifier: Apache-2.0
# cmake -DFOLDER=… -DTOOLCHAIN=… -DOUT=… -P embed.cmake: writes a C++ source with the files of FOLDER, by their relative paths
# without `.in`, and with the toolchain file of the microcontroller.
include(${CMAKE_CURRENT_LIST_DIR}/../../embed.cmake)
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${FOLDER} ${FOLDER}/*.in)
list(SORT files)
set(named "")
foreach(file ${files})
  string(REGEX REPLACE "\\.in$" "" name ${file})
  list(APPEND named ${name} ${FOLDER}/${file})
endforeach()
get_filename_component(toolchain ${TOOLCHAIN} NAME)
canproof_embed(${OUT} canproof::host project_templates host/app/new/templates.hpp "src/host/app/new/embed.cmake from template/"
               ${named} src/target/${toolchain} ${TOOLCHAIN})
