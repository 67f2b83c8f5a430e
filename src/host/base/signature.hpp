// SPDX-License-Identifier: Apache-2.0
// Signatures with keys in PEM files, compatible with `openssl`.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns the signature of the bytes by a private key. RSA and EC keys sign the SHA-256, Ed25519 keys the bytes
/// themselves. Throws InputError when the file contains no private key, or one with a password.
std::string sign(const std::string& bytes, const std::filesystem::path& private_key);

/// Returns whether the signature of the bytes matches the public key. Throws InputError when the file contains no
/// public key.
bool is_signed(const std::string& bytes, const std::string& signature, const std::filesystem::path& public_key);

}  // namespace canproof::host
