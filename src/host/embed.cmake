# SPDX-License-Identifier: Apache-2.0
# Writes files as a C++ source, for scripts that cmake -P runs.

# canproof_embed(OUT NAMESPACE FUNCTION HEADER ORIGIN NAME FILE [NAME FILE]…): writes NAMESPACE::FUNCTION(), which HEADER declares
# and which returns the bytes of each FILE by its NAME. ORIGIN names the generator in the written file.
function(canproof_embed out namespace function header origin)
  set(text "// Written by ${origin}. Do not edit.\n#include \"${header}\"\n\n")
  string(APPEND text "namespace ${namespace} {\n\nnamespace {\n\n")
  set(rows "")
  set(number 0)
  set(rest ${ARGN})
  while(rest)
    list(POP_FRONT rest name file)
    file(READ ${file} hex HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
    string(APPEND text "constexpr unsigned char file_${number}[]{${bytes}};\n")
    string(APPEND rows "        {\"${name}\", {std::begin(file_${number}), std::end(file_${number})}},\n")
    math(EXPR number "${number} + 1")
  endwhile()
  string(APPEND text "\n}  // namespace\n\nconst std::map<std::string, std::string>& ${function}() {\n")
  string(APPEND text "    static const std::map<std::string, std::string> files{\n${rows}    };\n    return files;\n}\n\n")
  string(APPEND text "}  // namespace ${namespace}\n")
  file(WRITE ${out} "${text}")
endfunction()
