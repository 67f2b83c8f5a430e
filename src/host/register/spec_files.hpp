// SPDX-License-Identifier: Apache-2.0
// The files of a requirements register as texts.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// First part of the paths of the shared rules.
inline const std::string shared_rules = "spec/canopen/";
/// First part of the paths of the cases of `canproof conform`, which do not belong to a register.
inline const std::string conformance_cases = "spec/conformance/";
/// First part of the path of a shared rule's file that belongs to an installed canproof. A project without its own
/// spec/canopen uses these files.
inline const std::string from_package = "canproof/";
/// The text of each file by its path, such as "spec/devices/NAME/device.toml".
using SpecFiles = std::map<std::string, std::string>;

/// Reads the .toml files below a folder, except the conformance cases. Each path begins with spec/, whatever the name
/// of the folder. Throws InputError when there are none.
SpecFiles read_spec_files(const std::filesystem::path& spec);
/// Returns `own` and, if it has no spec/canopen, also the shared rules of `package`. The paths of these rules then
/// begin with canproof/.
SpecFiles with_shared_rules(SpecFiles own, const SpecFiles& package);

}  // namespace canproof::host
