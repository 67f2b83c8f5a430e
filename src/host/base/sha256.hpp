// SPDX-License-Identifier: Apache-2.0
// SHA-256 of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace canproof::host {

/// Returns the SHA-256 as 64 hexadecimal digits in lower case.
std::string sha256(const std::string& bytes);

/// Hashes many short texts one after another and sets up the algorithm only once.
class Sha256 {
  public:
    /// Throws std::bad_alloc when memory is exhausted.
    Sha256();

    /// Returns the first `count` bytes of the hash, 1 to 8, as a big-endian number.
    std::uint64_t first_bytes(std::string_view bytes, std::size_t count);

  private:
    struct Free {
        void operator()(evp_md_ctx_st* context) const;
    };
    std::unique_ptr<evp_md_ctx_st, Free> context_;
};

}  // namespace canproof::host
