// The evidence pack: what is claimed, what shows it, what is open, for people and for the tools of others.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

/// Bytes by path within the pack.
using PackFiles = std::map<std::string, std::string>;

/// All files of the pack but the manifest. The same input gives the same bytes.
PackFiles make_pack(const PackInput& input);

/// manifest.json: SHA-256 of every file, and the provenance.
std::string write_manifest(const PackFiles& files, const Provenance& provenance);

}  // namespace canproof::host
