# SPDX-License-Identifier: Apache-2.0
# cmake -DFOLDER=… -DDEVICES=… -DOUT=… -P embed.cmake: writes a C++ source with the files of FOLDER/page as `page/FILE`, and with
# each DEVICES/NAME/simulation/panel.json as `views/NAME.json`.
include(${CMAKE_CURRENT_LIST_DIR}/../../embed.cmake)
file(GLOB files ${FOLDER}/page/* ${DEVICES}/*/simulation/panel.json)
list(SORT files)
set(named "")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  if(name STREQUAL panel.json)
    string(REGEX REPLACE ".*/([^/]+)/simulation/panel\\.json$" "views/\\1.json" name ${file})
  else()
    set(name page/${name})
  endif()
  list(APPEND named ${name} ${file})
endforeach()
canproof_embed(${OUT} canproof::host panel_assets host/app/panel/assets.hpp
               "src/host/app/panel/embed.cmake from page/ and the devices' panel.json" ${named})
