// SPDX-License-Identifier: Apache-2.0
#include "host/base/signature.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>
#include <openssl/pem.h>

#include <array>
#include <memory>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

using Key = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;
using Context = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;
using Memory = std::unique_ptr<BIO, decltype(&BIO_free)>;

/// Refuses a key with a password, because the program never asks for a password.
int no_password(char*, int, int, void*) {
    return -1;
}

template <typename Read>
Key key_in(const std::filesystem::path& file, const char* kind, const Read& read) {
    const std::string text = read_file(file);
    const Memory memory{BIO_new_mem_buf(text.data(), static_cast<int>(text.size())), &BIO_free};
    Key key{memory ? read(memory.get(), nullptr, no_password, nullptr) : nullptr, &EVP_PKEY_free};
    if (!key) {
        throw InputError{
            fmt::format("{} contains no {} key in PEM without a password; `openssl genpkey -algorithm ed25519` "
                        "makes a private key, `openssl pkey -pubout` its public key",
                        file.string(), kind)};
    }
    return key;
}

/// Returns the digest to sign; nullptr for Ed25519 and Ed448, which sign the bytes without a digest.
const EVP_MD* digest_for(const Key& key) {
    const int id = EVP_PKEY_get_base_id(key.get());
    return id == EVP_PKEY_ED25519 || id == EVP_PKEY_ED448 ? nullptr : EVP_sha256();
}

const unsigned char* bytes_of(const std::string& text) {
    return reinterpret_cast<const unsigned char*>(text.data());
}

}  // namespace

std::string sign(const std::string& bytes, const std::filesystem::path& private_key) {
    const Key key = key_in(private_key, "private", PEM_read_bio_PrivateKey);
    const Context context{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
    std::size_t size = 0;
    std::string signature;
    const bool begun = context &&
                       EVP_DigestSignInit(context.get(), nullptr, digest_for(key), nullptr, key.get()) == 1 &&
                       EVP_DigestSign(context.get(), nullptr, &size, bytes_of(bytes), bytes.size()) == 1;
    if (begun) {
        signature.resize(size);
    }
    if (!begun || EVP_DigestSign(context.get(), reinterpret_cast<unsigned char*>(signature.data()), &size,
                                 bytes_of(bytes), bytes.size()) != 1) {
        throw InputError{fmt::format("the key in {} cannot sign; use an Ed25519, EC or RSA key", private_key.string())};
    }
    signature.resize(size);
    return signature;
}

PublicKey public_key_of(const std::filesystem::path& private_key) {
    const Key key = key_in(private_key, "private", PEM_read_bio_PrivateKey);
    PublicKey made{EVP_PKEY_get0_type_name(key.get()), ""};
    if (EVP_PKEY_get_base_id(key.get()) == EVP_PKEY_ED25519) {
        std::array<unsigned char, 32> raw{};
        std::size_t size = raw.size();
        if (EVP_PKEY_get_raw_public_key(key.get(), raw.data(), &size) != 1) {
            throw InputError{
                fmt::format("cannot derive the public key from the private key in {}; use another private key",
                            private_key.string())};
        }
        made.text = fmt::format("{:02x}", fmt::join(raw, ""));
        return made;
    }
    std::array<char, 80> group{};
    if (EVP_PKEY_get_group_name(key.get(), group.data(), group.size(), nullptr) == 1) {
        made.kind += std::string{" "} + group.data();
    }
    const Memory memory{BIO_new(BIO_s_mem()), &BIO_free};
    char* text = nullptr;
    if (!memory || PEM_write_bio_PUBKEY(memory.get(), key.get()) != 1) {
        throw InputError{fmt::format("cannot derive the public key from the private key in {}; use another private key",
                                     private_key.string())};
    }
    const long size = BIO_get_mem_data(memory.get(), &text);
    made.text.assign(text, static_cast<std::size_t>(size) - 1U);
    return made;
}

bool is_signed(const std::string& bytes, const std::string& signature, const std::filesystem::path& public_key) {
    const Key key = key_in(public_key, "public", PEM_read_bio_PUBKEY);
    const Context context{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
    return context && EVP_DigestVerifyInit(context.get(), nullptr, digest_for(key), nullptr, key.get()) == 1 &&
           EVP_DigestVerify(context.get(), bytes_of(signature), signature.size(), bytes_of(bytes), bytes.size()) == 1;
}

}  // namespace canproof::host
