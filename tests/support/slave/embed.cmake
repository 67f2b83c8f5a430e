# cmake -DFOLDER=… -DOUT=… -P embed.cmake: writes the register of the conformance slave, the files below FOLDER/spec, into a
# C++ source.
include(${CMAKE_CURRENT_LIST_DIR}/../../../src/host/embed.cmake)
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${FOLDER} ${FOLDER}/spec/*.toml)
list(SORT files)
set(named "")
foreach(file ${files})
  list(APPEND named ${file} ${FOLDER}/${file})
endforeach()
canproof_embed(${OUT} canproof::test slave_files tests/support/slave_register.hpp "tests/support/slave/embed.cmake from spec/"
               ${named})
