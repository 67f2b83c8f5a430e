# cmake -DFOLDER=… -DPATTERN=… -DNAMESPACE=… -DFUNCTION=… -DHEADER=… -DOUT=… -P embed_folder.cmake: writes the files of FOLDER
# that fit PATTERN, by their path below FOLDER, into a C++ source.
include(${CMAKE_CURRENT_LIST_DIR}/embed.cmake)
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${FOLDER} ${FOLDER}/${PATTERN})
list(SORT files)
set(named "")
foreach(file ${files})
  list(APPEND named ${file} ${FOLDER}/${file})
endforeach()
canproof_embed(${OUT} ${NAMESPACE} ${FUNCTION} ${HEADER} "src/host/embed_folder.cmake from ${PATTERN}" ${named})
