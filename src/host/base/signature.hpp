// Signatures by keys in PEM files, as `openssl` makes and checks them.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// The signature of the bytes by a private key: RSA and EC keys sign their SHA-256, Ed25519 keys the bytes themselves.
/// Throws InputError when the file holds no private key, or one with a password.
std::string sign(const std::string& bytes, const std::filesystem::path& private_key);

/// Whether the public key made this signature of the bytes. Throws InputError when the file holds no public key.
bool is_signed(const std::string& bytes, const std::string& signature, const std::filesystem::path& public_key);

}  // namespace canproof::host
