// SPDX-License-Identifier: Apache-2.0
#include "host/prove/cell_contents.hpp"

#include <algorithm>
#include <set>

#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

/// Largest object, in bytes, that the prover accesses at an offset that is not a constant. Such an access becomes a
/// choice between all bytes of the object.
constexpr std::size_t most_choices = 8192;
/// Greatest number of bytes that are copied word by word when one of the two offsets is not a constant.
constexpr std::uint64_t most_in_words = 256;

void refuse_large(std::size_t size) {
    if (size > most_choices) {
        throw Unknown{
            "canproof prove does not support an offset that is not constant in an object of more than 8192 bytes"};
    }
}

/// Returns the size in bytes of the word whose bytes, from the first to the last, are in the cells from `at` on.
/// Returns 0 when the cells from `at` on do not contain a complete word.
unsigned whole_word(const std::vector<Cell>& cells, std::size_t at) {
    const unsigned bytes = width_of(cells[at].word) / byte_width;
    if (cells[at].byte != 0 || at + bytes > cells.size()) {
        return 0;
    }
    for (unsigned i = 1; i < bytes; ++i) {
        if (cells[at + i].byte != i || !same(cells[at + i].word, cells[at].word)) {
            return 0;
        }
    }
    return bytes;
}

/// Returns the last offset at which `bytes` bytes lie inside an object of `size` bytes and inside `reach`. `size` is at
/// least `bytes`.
std::size_t last_place(std::size_t size, unsigned bytes, const Reach& reach) {
    const std::uint64_t end = std::max<std::uint64_t>(std::min<std::uint64_t>(size, reach.end), bytes);
    return static_cast<std::size_t>(end - bytes);
}

/// The values up to `last` that an offset may have. They have equal distances: the distance is the element's size when
/// the offset selects an element of an array.
class Places {
  public:
    Places(const Term& offset, std::size_t last, const Reach& reach) : last_{last} {
        const KnownBits known = low_bits(offset);
        constexpr unsigned most = 32;
        const unsigned count = std::min(known.count, most);
        step_ = std::size_t{1} << count;
        first_ = static_cast<std::size_t>(known.bits & (step_ - 1));
        if (reach.first > first_) {
            first_ += (reach.first - first_ + step_ - 1) / step_ * step_;
        }
    }
    std::size_t first() const { return first_; }
    std::size_t step() const { return step_; }
    std::size_t last() const { return last_; }

  private:
    std::size_t first_{0};
    std::size_t step_{1};
    std::size_t last_;
};

/// Makes a term that chooses between the words at all possible offsets. Each bit of the offset halves the choice.
class Choice {
  public:
    Choice(const std::vector<Cell>& cells, const Term& offset, unsigned bytes, const Reach& reach)
        : cells_{cells}, bytes_{bytes}, first_{reach.first}, last_{last_place(cells.size(), bytes, reach)} {
        const KnownBits known = low_bits(offset);
        for (unsigned at = 0; (last_ >> at) != 0; ++at) {
            bits_.push_back(at < known.count ? offset.ctx().bool_val(((known.bits >> at) & 1U) != 0)
                                             : as_truth(offset.extract(at, at).simplify()));
        }
    }

    Term word() const { return from(0, bits_.size()); }

  private:
    /// Returns the choice between the words at the offsets from `low` on that differ from `low` only in the lowest
    /// `count` bits.
    Term from(std::size_t low, std::size_t count) const {
        if (count == 0) {
            return word_at(cells_, low, bytes_);
        }
        const std::size_t high = low + (std::size_t{1} << (count - 1));
        if (high > last_ || is_false(bits_[count - 1])) {  // an obligation excludes offsets behind `last_`
            return from(low, count - 1);
        }
        if (is_true(bits_[count - 1])) {
            return from(high, count - 1);
        }
        if (high <= first_) {
            return from(high, count - 1);
        }
        return choose(bits_[count - 1], from(high, count - 1), from(low, count - 1));
    }

    const std::vector<Cell>& cells_;
    unsigned bytes_;
    std::uint64_t first_;
    std::size_t last_;
    std::vector<Term> bits_;
};

bool same_cell(const Cell& a, const Cell& b) {
    return same(a.word, b.word) && a.byte == b.byte;
}

}  // namespace

bool same_except(const ContentsPointer& a, const ContentsPointer& b, const std::set<std::uint64_t>& open) {
    const auto* one = dynamic_cast<const CellContents*>(a.get());
    const auto* other = dynamic_cast<const CellContents*>(b.get());
    if (one == nullptr || other == nullptr || one->cells().size() != other->cells().size()) {
        return false;
    }
    for (std::size_t i = 0; i < one->cells().size(); ++i) {
        if (open.count(i) == 0 && !same_cell(one->cells()[i], other->cells()[i])) {
            return false;
        }
    }
    return true;
}

void put_word(std::vector<Cell>& cells, std::size_t at, const Term& word) {
    const unsigned bytes = width_of(word) / byte_width;
    for (unsigned i = 0; i < bytes; ++i) {
        cells[at + i] = Cell{word, i};
    }
}

Term word_at(const std::vector<Cell>& cells, std::size_t at, unsigned bytes) {
    if (whole_word(cells, at) == bytes) {
        return cells[at].word;
    }
    std::optional<Term> word;
    for (unsigned i = 0; i < bytes;) {
        const Cell& first = cells[at + i];
        unsigned run = 1;
        while (i + run < bytes && same(cells[at + i + run].word, first.word) &&
               cells[at + i + run].byte == first.byte + run) {
            ++run;
        }
        const Term part = first.word.extract(byte_width * (first.byte + run) - 1, byte_width * first.byte);
        word = word ? z3::concat(part, *word) : part;
        i += run;
    }
    return word->simplify();
}

std::shared_ptr<const CellContents> CellContents::unknown(std::uint64_t size, const MakeFresh& fresh) {
    std::vector<Cell> cells;
    cells.reserve(size);
    for (std::uint64_t i = 0; i < size; ++i) {
        cells.push_back(Cell{fresh(byte_width), 0});
    }
    return std::make_shared<CellContents>(std::move(cells));
}

Term CellContents::read(const Term& offset, unsigned bytes, const Reach& reach) const {
    // If the object is smaller than the access, the obligation of this access has failed, and the result does not
    // matter.
    if (cells_.size() < bytes) {
        return constant(offset.ctx(), 0, byte_width * bytes);
    }
    if (const auto at = number(offset)) {
        return *at <= cells_.size() - bytes ? word_at(cells_, *at, bytes)
                                            : constant(offset.ctx(), 0, byte_width * bytes);
    }
    refuse_large(cells_.size());
    return Choice{cells_, offset, bytes, reach}.word();
}

ContentsPointer CellContents::written(const Term& offset, const Term& word, const Reach& reach) const {
    const unsigned bytes = width_of(word) / byte_width;
    if (cells_.size() < bytes) {
        return shared_from_this();
    }
    std::vector<Cell> cells = cells_;
    if (const auto at = number(offset)) {
        if (*at <= cells.size() - bytes) {
            put_word(cells, *at, word);
        }
        return std::make_shared<CellContents>(std::move(cells));
    }
    refuse_large(cells.size());
    const Places places{offset, last_place(cells.size(), bytes, reach), reach};
    for (std::size_t at = places.first(); at <= places.last(); at += places.step()) {
        const Term here = (offset == constant(offset.ctx(), at, address_width)).simplify();
        if (!is_false(here)) {
            put_word(cells, at, choose(here, word, word_at(cells, at, bytes)));
        }
    }
    return std::make_shared<CellContents>(std::move(cells));
}

ContentsPointer CellContents::copied(const Term& offset, const ContentsPointer& source, const Term& from,
                                     const Term& count, const Reach& reach) const {
    std::vector<Cell> cells = cells_;
    const auto* source_cells = dynamic_cast<const CellContents*>(source.get());
    const auto to_number = number(offset);
    const auto from_number = number(from);
    const auto how_many = number(count);
    if (source_cells != nullptr && to_number && from_number && how_many) {
        for (std::uint64_t i = 0; i < *how_many; ++i) {
            if (*to_number + i < cells.size() && *from_number + i < source_cells->cells_.size()) {
                cells[*to_number + i] = source_cells->cells_[*from_number + i];
            }
        }
        return std::make_shared<CellContents>(std::move(cells));
    }
    refuse_large(cells.size());
    if (how_many && *how_many <= most_in_words && source_cells != nullptr) {
        return copied_in_words(offset, *source_cells, from, *how_many, reach);
    }
    const auto end = static_cast<std::size_t>(std::min<std::uint64_t>(cells.size(), reach.end));
    for (auto at = static_cast<std::size_t>(reach.first); at < end; ++at) {
        const Term behind = (constant(offset.ctx(), at, address_width) - offset).simplify();
        const Term inside = z3::ult(behind, count).simplify();
        if (!is_false(inside)) {
            const Term copy = source->read((from + behind).simplify(), 1, {});
            cells[at] = Cell{choose(inside, copy, byte_of(cells_[at].word, cells_[at].byte)), 0};
        }
    }
    return std::make_shared<CellContents>(std::move(cells));
}

ContentsPointer CellContents::copied_in_words(const Term& offset, const CellContents& source, const Term& from,
                                              std::uint64_t count, const Reach& reach) const {
    if (source.cells_.size() < count || cells_.size() < count) {
        return shared_from_this();
    }
    // distances, from the start of the copied bytes, of the places where a stored word may begin, whatever value `from`
    // has
    std::set<std::uint64_t> starts{0};
    const Places places{from, source.cells_.size() - count, {}};
    for (std::size_t at = places.first(); at <= places.last(); at += places.step()) {
        for (std::uint64_t i = 1; i < count; ++i) {
            const Cell& before = source.cells_[at + i - 1];
            const Cell& here = source.cells_[at + i];
            if (here.byte != before.byte + 1 || !same(here.word, before.word)) {
                starts.insert(i);
            }
        }
    }
    starts.insert(count);
    const auto plus = [](const Term& term, std::uint64_t more) {
        return (term + constant(term.ctx(), more, address_width)).simplify();
    };
    ContentsPointer next = shared_from_this();
    for (auto start = starts.begin(); std::next(start) != starts.end(); ++start) {
        const auto bytes = static_cast<unsigned>(*std::next(start) - *start);
        const Reach here{reach.first + *start,
                         reach.end == UINT64_MAX ? reach.end : reach.end - count + *std::next(start)};
        next = next->written(plus(offset, *start), source.read(plus(from, *start), bytes, {}), here);
    }
    return next;
}

ContentsPointer CellContents::merged(const Term& condition, const ContentsPointer& otherwise) const {
    const auto& others = dynamic_cast<const CellContents&>(*otherwise).cells_;
    std::vector<Cell> cells = cells_;
    for (std::size_t at = 0; at < cells.size();) {
        if (same_cell(cells_[at], others[at])) {
            ++at;
            continue;
        }
        const unsigned whole = whole_word(cells_, at);
        if (whole != 0 && whole == whole_word(others, at)) {
            put_word(cells, at, choose(condition, cells_[at].word, others[at].word));
            at += whole;
            continue;
        }
        cells[at] = Cell{
            choose(condition, byte_of(cells_[at].word, cells_[at].byte), byte_of(others[at].word, others[at].byte)), 0};
        ++at;
    }
    return std::make_shared<CellContents>(std::move(cells));
}

}  // namespace canproof::host::prove
