// SPDX-License-Identifier: Apache-2.0
#include "host/base/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/sha.h>

#include <array>
#include <new>

namespace canproof::host {

std::string sha256(const std::string& bytes) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
    SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
    std::string text;
    for (const unsigned char byte : digest) {
        text += fmt::format("{:02x}", byte);
    }
    return text;
}

Sha256::Sha256() : context_{EVP_MD_CTX_new()} {
    if (context_ == nullptr || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) {
        throw std::bad_alloc{};
    }
}

void Sha256::Free::operator()(evp_md_ctx_st* context) const {
    EVP_MD_CTX_free(context);
}

std::uint64_t Sha256::first_bytes(const std::string_view bytes, const std::size_t count) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
    const bool done = EVP_DigestInit_ex(context_.get(), nullptr, nullptr) == 1 &&
                      EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1 &&
                      EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1;
    if (!done) {
        throw std::bad_alloc{};  // the calculation of a digest in memory can fail for no other reason
    }
    std::uint64_t number = 0;
    constexpr unsigned bits = 8;
    for (std::size_t i = 0; i < count; ++i) {
        number = number << bits | digest[i];
    }
    return number;
}

}  // namespace canproof::host
