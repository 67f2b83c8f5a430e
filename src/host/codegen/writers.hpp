// What the compiler writes: C++ for the firmware, and the electronic data sheet.
#pragma once

#include <filesystem>
#include <string>

#include "host/codegen/dictionary_rows.hpp"
#include "host/datasheet/eds_values.hpp"

namespace canproof::host {

/// Whether the written cells can be altered in a running program: only test programs of `canproof mutate` are built so.
enum class Cells { constant, changeable };
/// `inline constexpr`, or `inline` where cells are to be changeable.
const char* storage_words(Cells cells);

std::string write_requirements(const Register& content, const Part& part);
std::string write_objects(const Part& part, Cells cells = Cells::constant);
std::string write_tables(const Register& content, const Part& part, Cells cells = Cells::constant);
std::string write_constants(const Part& part, Cells cells = Cells::constant);
/// One row an alteration: requirement, cell, address, and the bytes that replace it. Fits what is written changeable.
std::string write_alterations(const Register& content);
std::string write_enumerations(const Part& part);
/// The index of each object of a device, or of each standard object of the shared part, as a constant.
std::string write_indices(const Part& part);
/// The objects of which a device hears when they are written, as an enumeration and a function that finds it.
std::string write_written(const Part& part);
/// What device.toml says of the node, as a NodeProfile.
std::string write_profile(const Part& part, Cells cells = Cells::constant);
std::string write_signals(const Part& part);
std::string write_embedded(const SpecFiles& files);
/// All of them as files below `out`; files whose text stays the same are left alone.
void write_all(const Register& content, const SpecFiles& files, const std::filesystem::path& out,
               Cells cells = Cells::constant);

/// CiA 306 electronic data sheet, CRLF line ends.
std::string write_eds(const Register& content, const Part& part, Reals reals = Reals::without_limits);
/// The dictionary as JSON, one object an element.
std::string write_object_json(const Part& part);
/// The dictionary as a Markdown table.
std::string write_object_markdown(const Part& part);
/// CiA 311 XML device description.
std::string write_xdd(const Register& content, const Part& part);

/// FNV-1a (32 bit) of text: the fingerprint of layouts and of reviewed requirements.
std::uint32_t fnv1a(const std::string& text, std::uint32_t start = 0x811C9DC5U);

/// What opens a generated file: the files of the register that it was written from.
std::string heading(const Part& part);
/// `12U`, `-3`; `4.096F`: a value as a literal of a type that cpp_type() names; `0x1FFU` where it is unsigned and
/// hexadecimal is asked for.
std::string cpp_literal(const Value& value, const std::string& cpp_type_name, bool hexadecimal = false);
/// Narrowest standard integer type that holds both.
std::string cpp_integer_type(std::int64_t low, std::int64_t high);
/// What stands above an item in generated code: text, id, sources, unit.
std::string item_comment(const Item& item, const std::string& unit);
/// On one line, single spaces.
std::string one_line(const std::string& text);

/// `std::uint16_t` for UNSIGNED16 …
std::string cpp_type(const std::string& cia_type);

}  // namespace canproof::host
