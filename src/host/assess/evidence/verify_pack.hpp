// Whether a pack is what its manifest says, and who signed it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// Beside manifest.json: its signature.
inline constexpr const char* manifest_signature = "manifest.json.sig";

/// What is wrong with the pack, a sentence each: files that differ, are missing, or are not in the manifest; with a
/// public key (not empty) also a signature that is missing or is another's. Throws InputError without a manifest.
std::vector<std::string> faults_of_pack(const std::filesystem::path& folder, const std::filesystem::path& public_key);

}  // namespace canproof::host
