// SPDX-License-Identifier: Apache-2.0
// The files of a register as texts.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// First part of the paths of the shared rules.
inline const std::string shared_rules = "spec/canopen/";
/// First part of the paths of the cases of `canproof conform`, which do not belong to a register.
inline const std::string conformance_cases = "spec/conformance/";
/// First part of the path of a file that comes with canproof, in a project without spec/canopen.
inline const std::string from_package = "canproof/";
/// Text by path, such as "spec/devices/NAME/device.toml".
using SpecFiles = std::map<std::string, std::string>;

/// Reads the .toml files below a folder, with paths as if it were named spec/, without the conformance cases. Throws
/// InputError when there are none.
SpecFiles read_spec_files(const std::filesystem::path& spec);
/// Returns `own`, and the shared rules of `package` when `own` has no spec/canopen. The paths of these rules begin with
/// canproof/.
SpecFiles with_shared_rules(SpecFiles own, const SpecFiles& package);

}  // namespace canproof::host
