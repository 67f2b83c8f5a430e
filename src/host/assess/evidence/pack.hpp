// SPDX-License-Identifier: Apache-2.0
// The evidence pack: claims, evidence and open points, for people and for other tools.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

/// The bytes of each file of an evidence pack, by its path within the pack.
using PackFiles = std::map<std::string, std::string>;

/// Returns all files of the pack except the manifest. The same input gives the same bytes.
PackFiles make_pack(const PackInput& input);

/// Returns manifest.json: the SHA-256 of every file, and the provenance.
std::string write_manifest(const PackFiles& files, const Provenance& provenance);

}  // namespace canproof::host
