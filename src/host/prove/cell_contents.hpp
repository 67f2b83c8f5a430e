// SPDX-License-Identifier: Apache-2.0
// The contents of an object of known size: one cell for each byte.
#pragma once

#include <set>
#include <vector>

#include "host/prove/contents.hpp"

namespace canproof::host::prove {

/// One byte of an object: byte number `byte` of `word`. Because a cell keeps the whole word, a word that was stored at
/// once, such as an address, is read again as the same term.
struct Cell {
    Term word;
    unsigned byte{0};
};

class CellContents : public Contents, public std::enable_shared_from_this<CellContents> {
  public:
    explicit CellContents(std::vector<Cell> cells) : cells_{std::move(cells)} {}
    /// Makes `size` bytes with unknown values.
    static std::shared_ptr<const CellContents> unknown(std::uint64_t size, const MakeFresh& fresh);

    Term read(const Term& offset, unsigned bytes, const Reach& reach) const override;
    ContentsPointer written(const Term& offset, const Term& word, const Reach& reach) const override;
    ContentsPointer copied(const Term& offset, const ContentsPointer& source, const Term& from, const Term& count,
                           const Reach& reach) const override;
    ContentsPointer merged(const Term& condition, const ContentsPointer& otherwise) const override;

    const std::vector<Cell>& cells() const { return cells_; }

  private:
    ContentsPointer copied_in_words(const Term& offset, const CellContents& source, const Term& from,
                                    std::uint64_t count, const Reach& reach) const;

    std::vector<Cell> cells_;
};

/// Returns whether all cells are the same in both contents, except those at the offsets in `open`. Contents that are
/// not made of cells count as different.
bool same_except(const ContentsPointer& a, const ContentsPointer& b, const std::set<std::uint64_t>& open);
/// Stores the bytes of a word in the cells from `at` on.
void put_word(std::vector<Cell>& cells, std::size_t at, const Term& word);
/// Returns the `bytes` cells from `at` on as one word.
Term word_at(const std::vector<Cell>& cells, std::size_t at, unsigned bytes);

}  // namespace canproof::host::prove
