# SPDX-License-Identifier: Apache-2.0
# cmake -DFOLDER=… -DPATTERN=… -DNAMESPACE=… -DFUNCTION=… -DHEADER=… -DOUT=… -P embed_folder.cmake: writes a C++ source with the
# files of FOLDER that match PATTERN, by their relative paths.
include(${CMAKE_CURRENT_LIST_DIR}/embed.cmake)
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${FOLDER} ${FOLDER}/${PATTERN})
list(SORT files)
set(named "")
foreach(file ${files})
  list(APPEND named ${file} ${FOLDER}/${file})
endforeach()
canproof_embed(${OUT} ${NAMESPACE} ${FUNCTION} ${HEADER} "src/host/embed_folder.cmake from ${PATTERN}" ${named})
