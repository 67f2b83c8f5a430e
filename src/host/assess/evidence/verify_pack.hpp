// SPDX-License-Identifier: Apache-2.0
// Verifies an evidence pack against its manifest and its signature.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// Name of the file with the signature of manifest.json, in the same folder.
inline constexpr const char* manifest_signature = "manifest.json.sig";

/// Returns the faults of the pack, one sentence each: files that differ, are missing, or are not in the manifest. If
/// `public_key` is not empty, also reports a missing or invalid signature. Throws InputError when the manifest is
/// missing or not valid.
std::vector<std::string> faults_of_pack(const std::filesystem::path& folder, const std::filesystem::path& public_key);

}  // namespace canproof::host
