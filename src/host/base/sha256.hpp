// SHA-256 of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace canproof::host {

/// 64 small hexadecimal digits.
std::string sha256(const std::string& bytes);

/// Hashes many short texts one after another: it sets the algorithm up once.
class Sha256 {
  public:
    /// Throws std::bad_alloc without memory.
    Sha256();

    /// The first `count` bytes of the hash, 1 to 8, as a number of which the first byte is the highest.
    std::uint64_t first_bytes(std::string_view bytes, std::size_t count);

  private:
    struct Free {
        void operator()(evp_md_ctx_st* context) const;
    };
    std::unique_ptr<evp_md_ctx_st, Free> context_;
};

}  // namespace canproof::host
