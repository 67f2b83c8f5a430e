// Reading a decision table: the register's compiler proves each table total over its inputs, so that a missing row
// means memory gone wrong; the caller says which value is safe then.
#pragma once

namespace canproof {

/// What `row` says in `column`; `otherwise` where `find` gave no row.
template <typename Row, typename Cell>
constexpr Cell cell_or(const Row* const row, Cell Row::*const column, const Cell otherwise) noexcept {
    return (row == nullptr) ? otherwise : row->*column;
}

}  // namespace canproof
