// SPDX-License-Identifier: Apache-2.0
// The pack's metadata for in-toto: a layout and a link, both signed. Source: the in-toto specification, version 0.9.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "host/assess/evidence/pack.hpp"

namespace canproof::host {

/// Path of the in-toto layout within a pack.
inline constexpr const char* in_toto_layout = "in-toto/root.layout";

/// Returns whether a pack's file is metadata of in-toto, which the manifest does not list.
bool is_in_toto_file(const std::string& name);

/// Returns the in-toto layout and link by file name. `products` are the files of the pack with its manifest.
/// `materials` has the SHA-256, by name, of the files from which the pack was made. Returns nothing for a key that is
/// neither Ed25519 nor ECDSA on P-256. Throws InputError for a file that is no private key.
PackFiles in_toto_files(const PackFiles& products, const std::map<std::string, std::string>& materials,
                        const Provenance& provenance, const std::filesystem::path& private_key);

}  // namespace canproof::host
