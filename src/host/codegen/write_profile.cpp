// SPDX-License-Identifier: Apache-2.0
// Generates the firmware's NodeProfile from device.toml, and its ErrorTable from the tables of errors.
#include "host/codegen/write_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host {

namespace {

/// The LSS settings of the profile, and the table of bit rates to which they refer.
struct LssWords {
    std::string rates;
    std::string profile;
};

LssWords lss_words(const Part& part, Cells cells) {
    const DeviceInfo& info = part.info;
    if (!info.lss) {
        return {"", "LssProfile{}"};
    }
    const auto found = std::find_if(part.tables.begin(), part.tables.end(),
                                    [&](const Table& table) { return table.id == info.lss_bit_rates; });
    const std::string table = found == part.tables.end() ? "canopen::lss_bit_rates" : found->name;
    return {
        fmt::format("/// The bit rates that LSS can set.\n{} auto lss_rates = canproof::lss_bit_rates({}::rows);\n\n",
                    cells == Cells::constant ? "inline constexpr" : "inline const", table),
        fmt::format("LssProfile{{lss_rates, {}}}", info.lss_reset)};
}

bool has_column(const Table& table, const std::string& name) {
    return std::any_of(table.outputs.begin(), table.outputs.end(),
                       [&](const Column& column) { return column.name == name; });
}

/// Returns a C++ expression for the upper 16 bits of an error's entry in 1003h (pre-defined error field).
std::string detail_of(const Table& table) {
    if (has_column(table, "detail")) {
        return "row.detail";
    }
    return has_column(table, "description")
               ? "static_cast<std::uint16_t>((static_cast<std::uint32_t>(row.description) << 8U) | row.channel)"
               : "0U";
}

/// Returns the statements that put the rows of one table into the ErrorTable. A table without a column `register_bits`
/// sets only the generic error bit (01h). A table without a column `sent` or `listed` sends or lists every error.
std::string put_rows(const Table& table) {
    const auto code = std::find_if(table.outputs.begin(), table.outputs.end(),
                                   [](const Column& column) { return column.name == "code"; });
    const bool named = code != table.outputs.end() && !code->enumeration.empty();
    return fmt::format(
        "    for (const {0}::Row& row : {0}::rows) {{\n"
        "        put_error(table, row.{1}, ErrorRow{{{2}, {3}, {4}, {5}, {6}}});\n    }}\n",
        table.name, table.errors, named ? "static_cast<std::uint16_t>(row.code)" : "row.code",
        has_column(table, "register_bits") ? "row.register_bits" : "0x01U",
        has_column(table, "sent") ? "row.sent" : "true", has_column(table, "listed") ? "row.listed" : "true",
        detail_of(table));
}

std::string error_table(const Part& part, Cells cells) {
    std::string rows;
    for (const Table& table : part.tables) {
        rows += table.errors.empty() ? "" : put_rows(table);
    }
    return fmt::format(
        "/// Returns how the node reports each of its errors.\nconstexpr ErrorTable make_error_table() noexcept {{\n"
        "    ErrorTable table{{}};\n{}    return table;\n}}\n{} ErrorTable error_table = make_error_table();\n\n",
        rows, cells == Cells::constant ? "inline constexpr" : "inline const");
}

}  // namespace

std::string write_profile(const Part& part, Cells cells) {
    const DeviceInfo& info = part.info;
    unsigned remote = 0;
    for (const std::int64_t number : info.rpdos_answering_remote) {
        remote |= 1U << static_cast<unsigned>(number - 1);
    }
    const LssWords lss = lss_words(part, cells);
    std::string text = fmt::format(
        "// Written by canproof's speccompiler from\n//   spec/devices/{}/device.toml\n"
        "// Do not edit: change the register.\n#pragma once\n\n",
        part.name);
    text +=
        "#include \"firmware/canopen/error_table.hpp\"\n#include \"firmware/canopen/node.hpp\"\n#include "
        "\"generated/canopen/tables.hpp\"\n";
    text += fmt::format("#include \"generated/{0}/tables.hpp\"\n\nnamespace canproof::generated::{0} {{\n\n",
                        part.cpp_name());
    text += lss.rates;
    text += fmt::format(
        "/// The services of the node, in addition to its objects.\n"
        "{} NodeProfile profile{{\n"
        "    LimitAbort::{},\n    ErrorList::{},\n    EmcyContent::{},\n    0x{:02X}U,\n"
        "    {},\n    {},\n    {},\n    TpdoTrigger::{}}};\n\n",
        cells == Cells::constant ? "inline constexpr" : "inline const", info.limit_abort, info.error_list,
        info.emcy_content, remote, info.saves_in_pre_operational_only, info.block_sdo, lss.profile, info.tpdo_trigger);
    text += error_table(part, cells);
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
