// SPDX-License-Identifier: Apache-2.0
// Theorem on numbers of any length that are put into memory, least significant byte first. Its 54 cases take several
// seconds.
#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/numbers_in_memory.hpp"

namespace canproof::proofs {

void set_le_puts_what_fits() {
    shows("set_le() and write_le() put 0 to 8 bytes, the least significant first, and change nothing else");
    const Span span = any_span(each(longest + 1U));
    const Other other = any_other(span);
    const std::uint64_t value = any<std::uint64_t>();
    write_le(span.bytes(), span.at, span.count, value);
    claim_put(span, other, value);
}

}  // namespace canproof::proofs
