// SPDX-License-Identifier: Apache-2.0
// Generates the firmware's NodeProfile from device.toml.
#include "host/codegen/write_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host {

namespace {

/// The LSS part of the profile, and the table of bit rates to which this part refers.
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
    text += "#include \"firmware/canopen/node.hpp\"\n#include \"generated/canopen/tables.hpp\"\n";
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
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
