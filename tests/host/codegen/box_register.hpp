// SPDX-License-Identifier: Apache-2.0
// The device `box` as described in a register: the folder box/ beside this file, which is compiled in.
#pragma once

#include <map>
#include <string>

namespace canproof::host::test {

/// Returns the texts of the objects (`box/objects.toml`), of the behaviour, and of the enumerations of CANopen that it
/// uses (`shared`).
const std::map<std::string, std::string>& box_files();

}  // namespace canproof::host::test
