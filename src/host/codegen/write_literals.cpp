// SPDX-License-Identifier: Apache-2.0
// Constants, enumerations and signals as C++.
#include "host/codegen/write_literals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/one_line.hpp"
#include "host/codegen/cpp_text.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

std::string opening(const Part& part, const std::string& includes) {
    return fmt::format("{}{}\nnamespace canproof::generated::{} {{\n\n", heading(part), includes, part.cpp_name());
}

std::string ending(const Part& part) {
    return fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

std::string member_name(const Signal& signal) {
    std::string name = signal.name;
    if (const auto at = name.find("{n}"); at != std::string::npos) {
        name.erase(at, 3);
    }
    return name;
}

std::string member(const Signal& signal) {
    const std::string type = cpp_type(signal.type);
    const std::string value = cpp_literal(signal.value, type);
    const std::string unit = signal.unit.empty() ? "" : " [" + signal.unit + "]";
    const std::string note = fmt::format("  ///< {} ({}){}\n", one_line(signal.text), signal.id, unit);
    if (signal.count == 1) {
        return fmt::format("    {} {}{{{}}};{}", type, member_name(signal), value, note);
    }
    const std::vector<std::string> values(static_cast<std::size_t>(signal.count), value);
    return fmt::format("    std::array<{}, {}U> {}{{{{{}}}}};{}", type, signal.count, member_name(signal),
                       fmt::join(values, ", "), note);
}

/// Returns the function template for_each_input or for_each_output. It calls visit(name, value) for each signal, and
/// for each element of a signal with several elements. The host uses it to access signals by name.
std::string visitor(const Part& part, bool input) {
    const std::string group = input ? "input" : "output";
    std::string calls;
    for (const Signal& signal : part.signals) {
        if (signal.input != input) {
            continue;
        }
        const auto names = signal.names();
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::string at = signal.count > 1 ? fmt::format("[{}U]", i) : "";
            calls += fmt::format("    visit(\"{}\", group.{}{});\n", names[i], member_name(signal), at);
        }
    }
    if (calls.empty()) {
        return fmt::format(
            "/// The device has no {0}s.\ntemplate <typename Group, typename Visit>\n"
            "constexpr void for_each_{0}(Group&, const Visit&) noexcept {{}}\n\n",
            group);
    }
    return fmt::format(
        "/// Calls visit(name, value) for each {0} in the register's order.\ntemplate <typename Group, typename "
        "Visit>\n"
        "constexpr void for_each_{0}(Group& group, const Visit& visit) {{\n{1}}}\n\n",
        group, calls);
}

/// Returns the C++ type of a constant; an unsigned type has at least 32 bits. A narrower operand would be promoted to
/// int, which changes its signedness (MISRA C++:2023 7.0.5).
std::string constant_type(const std::string& type) {
    const std::string exact = cpp_type(type);
    return exact == "std::uint8_t" || exact == "std::uint16_t" ? "std::uint32_t" : exact;
}

}  // namespace

std::string write_constants(const Part& part, Cells cells) {
    std::string text = opening(part, "#include <cstdint>\n");
    for (const Constant& constant : part.constants) {
        // In generated code, braces may initialise a narrower type from a constant whose value fits, but not from a
        // variable of a wider type. A changeable cell (a generated value that a running program can alter) is a
        // variable, so it has exactly the type that the register states.
        const bool fixed = cells == Cells::constant || constant.compiled_in;
        const std::string type = fixed ? constant_type(constant.type) : cpp_type(constant.type);
        text += item_comment(constant, constant.unit);
        text += fmt::format("{} {} {}{{{}}};\n", storage_words(fixed ? Cells::constant : cells), type, constant.name,
                            cpp_literal(constant.value, type, constant.hexadecimal));
    }
    return text + "\n" + ending(part);
}

std::string write_enumerations(const Part& part) {
    std::string text = opening(part, "#include <cstdint>\n");
    for (const Enumeration& enumeration : part.enumerations) {
        auto values = enumeration.values;
        std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        const std::string type = cpp_integer_type(values.front().second, values.back().second);
        text += item_comment(enumeration, "");
        text += fmt::format("enum class {} : {} {{\n", enumeration.name, type);
        for (const auto& [word, number] : values) {
            text += fmt::format("    {} = {},\n", cpp_word(word), cpp_literal(number, type, enumeration.hexadecimal));
        }
        text += "};\n\n";
    }
    return text + ending(part);
}

std::string write_signals(const Part& part) {
    std::string text = opening(part, "#include <array>\n#include <cstdint>\n");
    for (const bool input : {true, false}) {
        text += input ? "/// Physical inputs of the device.\nstruct Inputs {\n"
                      : "/// Physical outputs of the device.\nstruct Outputs {\n";
        for (const Signal& signal : part.signals) {
            if (signal.input == input) {
                text += member(signal);
            }
        }
        text += "};\n\n" + visitor(part, input);
    }
    return text + ending(part);
}

}  // namespace canproof::host
