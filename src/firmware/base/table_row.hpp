// SPDX-License-Identifier: Apache-2.0
// Reads a row of a decision table. The generator of the tables proves that each table has a row for all its inputs. A
// missing row therefore means corrupt memory; the caller passes the value that is safe in that case.
#pragma once

namespace canproof {

/// Returns the cell of `row` in `column`; `otherwise` when `row` is nullptr.
template <typename Row, typename Cell>
constexpr Cell cell_or(const Row* const row, Cell Row::*const column, const Cell otherwise) noexcept {
    return (row == nullptr) ? otherwise : row->*column;
}

}  // namespace canproof
