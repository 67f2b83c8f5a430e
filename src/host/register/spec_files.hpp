// The files of a register, as texts.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// Begins the paths of the shared rules.
inline const std::string shared_rules = "spec/canopen/";
/// Begins the paths of the cases of `canproof conform`, which are no part of a register.
inline const std::string conformance_cases = "spec/conformance/";
/// Begins the path of a file that comes with canproof itself, in a project without spec/canopen.
inline const std::string from_package = "canproof/";
/// Files by path: "spec/devices/NAME/device.toml" → text.
using SpecFiles = std::map<std::string, std::string>;

/// The .toml files below a folder, as if it were named spec/, without the conformance cases. Throws InputError when
/// there are none.
SpecFiles read_spec_files(const std::filesystem::path& spec);
/// `own`, with the shared rules of `package` when it has no spec/canopen of its own: paths of these begin with
/// canproof/.
SpecFiles with_shared_rules(SpecFiles own, const SpecFiles& package);

}  // namespace canproof::host
