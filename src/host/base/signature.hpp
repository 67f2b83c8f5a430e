// SPDX-License-Identifier: Apache-2.0
// Signatures with keys in PEM files, compatible with `openssl`.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns the signature of the bytes by a private key. RSA and EC keys sign the SHA-256 of the bytes; Ed25519 and
/// Ed448 keys sign the bytes themselves. Throws InputError when the file contains no private key, a key with a
/// password, or a key that cannot sign.
std::string sign(const std::string& bytes, const std::filesystem::path& private_key);

/// Returns whether the signature of the bytes matches the public key. Throws InputError when the file contains no
/// public key.
bool is_signed(const std::string& bytes, const std::string& signature, const std::filesystem::path& public_key);

/// The public half of a private key.
struct PublicKey {
    std::string kind;  ///< `ED25519`, `EC prime256v1`, or OpenSSL's name for another kind
    std::string text;  ///< for Ed25519 the 32 bytes in hexadecimal, otherwise PEM without the last line break
};

/// Returns the public key that belongs to the private key in a PEM file. Throws InputError when the file contains no
/// private key, a key with a password, or a key whose public key cannot be derived.
PublicKey public_key_of(const std::filesystem::path& private_key);

}  // namespace canproof::host
