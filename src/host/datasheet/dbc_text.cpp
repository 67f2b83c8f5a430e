// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/dbc_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/datasheet/ini.hpp"

namespace canproof::host {

namespace {

constexpr std::uint32_t extended_frame = 0x80000000;

/// Returns the text in quotation marks, reduced to ASCII without quotation marks, backslashes and line breaks.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        out += c == '"' || c == '\\' ? '\'' : byte < 0x20U ? ' ' : byte > 0x7EU ? '?' : c;
    }
    return out + "\"";
}

std::uint32_t id_of(const DbcMessage& message) {
    return message.id | (message.is_extended ? extended_frame : 0U);
}

std::string multiplex_of(const DbcSignal& signal) {
    switch (signal.multiplex) {
        case DbcSignal::Multiplex::switches:
            return " M";
        case DbcSignal::Multiplex::switched:
            return fmt::format(" m{}", signal.switched_by);
        default:
            return "";
    }
}

bool is_real(const DbcSignal& signal) {
    return signal.number == DbcSignal::Number::single_real || signal.number == DbcSignal::Number::double_real;
}

std::string signal_text(const DbcSignal& signal, const std::string& receiver) {
    const bool has_sign = signal.number != DbcSignal::Number::natural;
    return fmt::format(" SG_ {}{} : {}|{}@1{} (1,0) [{}|{}] {} {}\n", signal.name, multiplex_of(signal), signal.start,
                       signal.length, has_sign ? '-' : '+', signal.minimum, signal.maximum, quoted(signal.unit),
                       receiver);
}

std::string words_text(const DbcMessage& message, const DbcSignal& signal) {
    std::string out = fmt::format("VAL_ {} {}", id_of(message), signal.name);
    for (const auto& [value, word] : signal.words) {
        out += fmt::format(" {} {}", value, quoted(word));
    }
    return out + " ;\n";
}

}  // namespace

std::string DbcNames::take(const std::string& text) {
    std::string name;
    for (const char c : text) {
        const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (fits) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    if (name.empty() || (name.front() >= '0' && name.front() <= '9')) {
        name.insert(0, "n");
    }
    const auto cut = [](std::string word, std::size_t most) {
        word.resize(std::min(word.size(), most));
        while (word.back() == '_') {
            word.pop_back();
        }
        return word;
    };
    std::string unique = cut(name, most_);
    for (unsigned number = 2; unique == "VERSION" || !taken_.insert(lower_case(unique)).second; ++number) {
        const std::string tail = fmt::format("_{}", number);
        unique = cut(name, most_ - tail.size()) + tail;
    }
    return unique;
}

std::string dbc_text(const DbcFile& file) {
    std::string out = "VERSION \"\"\n\nNS_ :\n\nBS_:\n\n";
    out += fmt::format("BU_: {}\n\n", fmt::join(file.nodes, " "));
    std::string comments = file.comment.empty() ? "" : "CM_ " + quoted(file.comment) + ";\n";
    std::string words;
    std::string reals;
    for (const DbcMessage& message : file.messages) {
        const std::uint32_t id = id_of(message);
        out += fmt::format("BO_ {} {}: {} {}\n", id, message.name, message.length, message.sender);
        if (!message.comment.empty()) {
            comments += fmt::format("CM_ BO_ {} {};\n", id, quoted(message.comment));
        }
        for (const DbcSignal& signal : message.signals) {
            out += signal_text(signal, message.receiver);
            if (!signal.comment.empty()) {
                comments += fmt::format("CM_ SG_ {} {} {};\n", id, signal.name, quoted(signal.comment));
            }
            if (!signal.words.empty()) {
                words += words_text(message, signal);
            }
            if (is_real(signal)) {
                const bool single = signal.number == DbcSignal::Number::single_real;
                reals += fmt::format("SIG_VALTYPE_ {} {} : {};\n", id, signal.name, single ? 1 : 2);
            }
        }
        out += "\n";
    }
    return out + comments + words + reals;
}

}  // namespace canproof::host
