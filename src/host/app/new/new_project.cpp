// SPDX-License-Identifier: Apache-2.0
#include "host/app/new/new_project.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include "host/app/new/templates.hpp"
#include "host/base/cia301.hpp"
#include "host/base/input_error.hpp"
#include "host/datasheet/write_objects_toml.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

constexpr std::int64_t usual_bit_rate = 125000;
constexpr int usual_node_id = 1;
constexpr std::size_t longest_name = 40;

/// Returns the names that a new project must not have, because canproof uses them itself. is_cpp_name() refuses the
/// keywords of C++.
const std::set<std::string>& taken_words() {
    static const std::set<std::string> words{"canopen", "canproof", "fuzz",   "generated", "host",
                                             "req",     "std",      "target", "test"};
    return words;
}

std::string cpp_word(const std::string& name) {
    std::string word = name;
    std::replace(word.begin(), word.end(), '-', '_');
    return word;
}

std::string capitals(const std::string& name) {
    std::string text;
    for (const char letter : name) {
        if (letter != '-') {
            text += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
        }
    }
    return text;
}

void check_name(const std::string& name) {
    static const std::regex form{"[a-z][a-z0-9]*(-[a-z0-9]+)*"};
    if (!std::regex_match(name, form) || name.size() > longest_name) {
        throw InputError{
            fmt::format("`{}` is no name of a device: write small letters, digits and single dashes, a letter first, "
                        "at most {} characters",
                        name, longest_name)};
    }
    if (taken_words().count(cpp_word(name)) != 0 || !is_cpp_name(cpp_word(name))) {
        throw InputError{fmt::format("`{}` is a word of C++ or of canproof; choose another name", name)};
    }
}

void check_prefix(const std::string& prefix) {
    static const std::regex form{"[A-Z][A-Z0-9]*"};
    if (!std::regex_match(prefix, form) || prefix.size() > longest_name) {
        throw InputError{fmt::format(
            "`{}` is no prefix of item ids: write capital letters and digits, a letter first, at most {} characters",
            prefix, longest_name)};
    }
    if (prefix == "CO") {
        throw InputError{"CO is the prefix of the shared rules; choose another prefix with --prefix"};
    }
}

/// Returns the text as content of a TOML or C++ string: quotes, backslashes and control characters become spaces.
std::string quotable(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        out += byte < 0x20 || byte == 0x7F || letter == '"' || letter == '\\' ? ' ' : letter;
    }
    return out;
}

/// Returns the first entry of an object; nullptr when the device does not have the object.
const Entry* first_entry(const Part& part, unsigned index) {
    const auto found = std::find_if(part.objects.begin(), part.objects.end(), [index](const Object& object) {
        return object.index == index && !object.entries.empty();
    });
    return found == part.objects.end() ? nullptr : &found->entries.front();
}

std::int64_t number_of(const Entry* entry) {
    const auto* number = entry == nullptr ? nullptr : std::get_if<std::int64_t>(&entry->value);
    return number == nullptr ? 0 : *number;
}

/// Returns the C++ code of a test function. This function returns the emergency frame of node 5. The default of 1014h
/// COB-ID EMCY determines the frame's COB-ID.
std::string emergency_of(const Part& part) {
    constexpr int node = 5;
    constexpr std::int64_t switched_off = 0x80000000;
    const Entry* const cob_id = first_entry(part, cia301::emcy_cob_id);
    const std::int64_t base = cob_id == nullptr ? 0x80 : number_of(cob_id);
    if ((base & switched_off) != 0) {
        return "/// Returns no frame: the default of 1014h (COB-ID EMCY) switches emergency messages off.\n"
               "Frames emergency(const std::string&) {\n    return {};\n}";
    }
    const std::int64_t id = (base + (cob_id == nullptr || cob_id->node_id ? node : 0)) & 0x7FF;
    return fmt::format(
        "/// Returns the emergency message of node 5 with these bytes.\n"
        "Frames emergency(const std::string& bytes) {{\n    return {{\"{:03X}#\" + bytes}};\n}}",
        id);
}

/// Returns the usual bit rates and the bit rate `shipped`, all in bit/s, as a list separated by commas.
std::string bit_rates_with(std::int64_t shipped) {
    std::set<std::int64_t> rates{10000, 20000, 50000, 125000, 250000, 500000, 800000, 1000000};
    rates.insert(shipped);
    return fmt::format("{}", fmt::join(rates, ", "));
}

using Words = std::map<std::string, std::string>;

Words words_of(const NewProject& project, const std::string& prefix) {
    Words words{{"name", project.name},
                {"word", cpp_word(project.name)},
                {"Type", pascal_case(project.name)},
                {"prefix", prefix},
                {"date", project.date}};
    const DeviceInfo info = project.eds ? project.eds->info : DeviceInfo{};
    const int node = info.node_id > 0 ? info.node_id : usual_node_id;
    words["title"] = quotable(info.title.empty() ? project.name : info.title);
    words["vendor"] = quotable(info.vendor.empty() ? "manufacturer of " + project.name : info.vendor);
    words["part_number"] = quotable(info.part_numbers.empty() ? capitals(project.name) : info.part_numbers.front());
    words["manual"] = quotable(project.manual.empty() ? words["title"] + " manual" : project.manual);
    words["node_id"] = std::to_string(node);
    words["node_hex"] = fmt::format("{:02X}", node);
    words["request_id"] = fmt::format("{:03X}", 0x600 + node);
    const Part sheet = project.eds ? *project.eds : Part{};
    const std::int64_t bit_rate = info.bit_rate > 0 ? info.bit_rate : usual_bit_rate;
    words["boot_id"] = fmt::format("{:03X}", 0x700 + node);
    words["bit_rate"] = std::to_string(bit_rate);
    words["bit_rates"] = bit_rates_with(bit_rate);
    words["device_type"] = fmt::format("0x{:08X}", number_of(first_entry(sheet, cia301::device_type)));
    words["emergency"] = emergency_of(sheet);
    return words;
}

/// Returns the text in which each @word@ is replaced by its value in `words`. A @word@ that `words` does not contain
/// stays.
std::string filled(const std::string& text, const Words& words) {
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = text[at] == '@' ? text.find('@', at + 1) : std::string::npos;
        const auto found = end == std::string::npos ? words.end() : words.find(text.substr(at + 1, end - at - 1));
        if (found == words.end()) {
            out += text[at++];
        } else {
            out += found->second;
            at = end + 1;
        }
    }
    return out;
}

}  // namespace

std::map<std::string, std::string> project_files(const NewProject& project) {
    check_name(project.name);
    const std::string prefix = project.prefix.empty() ? capitals(project.name) : project.prefix;
    check_prefix(prefix);
    const Words words = words_of(project, prefix);
    std::map<std::string, std::string> files;
    for (const auto& [path, text] : project_templates()) {
        const std::string place = filled(path, words);
        // Files of a corpus are binary, so they are copied unchanged.
        files[place] = path.find("/corpus/") == std::string::npos ? filled(text, words) : text;
    }
    if (project.eds) {
        files["spec/devices/" + project.name + "/objects/objects.toml"] =
            write_objects_toml(*project.eds, prefix + ":1");
    }
    return files;
}

}  // namespace canproof::host
