// SPDX-License-Identifier: Apache-2.0
// Indices of objects as C++ constants.
#include "host/codegen/write_indices.hpp"

#include <fmt/format.h>

#include <map>

#include "host/codegen/cpp_text.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

/// Returns an index as a constant of 32 bits. A narrower operand would be promoted to int, which changes its signedness
/// (MISRA C++:2023 7.0.5).
std::string index_constant(std::uint16_t index, const std::string& name) {
    return fmt::format("inline constexpr std::uint32_t {} = 0x{:04X}U;\n", cpp_word(name), index);
}

}  // namespace

std::string write_indices(const Part& part) {
    std::string text = heading(part);
    text += "#include <cstdint>\n\n";
    text += fmt::format("/// Indices of objects, by their names.\nnamespace canproof::generated::{}::index {{\n\n",
                        part.cpp_name());
    for (const StandardObject& object : part.standard_objects) {
        text += index_constant(object.index, object.name);
    }
    std::map<std::string, int> uses;
    for (const Object& object : part.objects) {
        ++uses[cpp_word(object.name)];
    }
    for (const Object& object : part.objects) {
        const std::string name = cpp_word(object.name);
        const bool is_clear = !name.empty() && uses[name] == 1;
        text += index_constant(object.index, is_clear ? name : fmt::format("{} {:04x}", name, object.index));
    }
    return text + fmt::format("\n}}  // namespace canproof::generated::{}::index\n", part.cpp_name());
}

}  // namespace canproof::host
