// SPDX-License-Identifier: Apache-2.0
#include "host/prove/layered_contents.hpp"

namespace canproof::host::prove {

namespace {

Term plus(const Term& offset, unsigned more) {
    return more == 0 ? offset : (offset + constant(offset.ctx(), more, address_width)).simplify();
}

class Written : public LayeredContents {
  public:
    Written(ContentsPointer below, const Term& offset, const Term& word)
        : below_{std::move(below)}, offset_{offset}, word_{word} {}

    Term at(const Term& offset) const override {
        const Term behind = (offset - offset_).simplify();
        const unsigned bytes = width_of(word_) / byte_width;
        if (const auto byte = number(behind)) {
            return *byte < bytes ? byte_of(word_, static_cast<unsigned>(*byte)) : below_->read(offset, 1);
        }
        Term value = below_->read(offset, 1);
        for (unsigned byte = 0; byte < bytes; ++byte) {
            const Term here = (behind == constant(offset.ctx(), byte, address_width)).simplify();
            value = choose(here, byte_of(word_, byte), value);
        }
        return value;
    }

  private:
    ContentsPointer below_;
    Term offset_;
    Term word_;
};

class Copied : public LayeredContents {
  public:
    Copied(ContentsPointer below, const Term& offset, ContentsPointer source, const Term& from, const Term& count)
        : below_{std::move(below)}, offset_{offset}, source_{std::move(source)}, from_{from}, count_{count} {}

    Term at(const Term& offset) const override {
        const Term behind = (offset - offset_).simplify();
        const Term inside = z3::ult(behind, count_).simplify();
        if (is_false(inside)) {
            return below_->read(offset, 1);
        }
        const Term copy = source_->read((from_ + behind).simplify(), 1);
        return is_true(inside) ? copy : choose(inside, copy, below_->read(offset, 1));
    }

  private:
    ContentsPointer below_;
    Term offset_;
    ContentsPointer source_;
    Term from_;
    Term count_;
};

class Merged : public LayeredContents {
  public:
    Merged(const Term& condition, ContentsPointer then, ContentsPointer otherwise)
        : condition_{condition}, then_{std::move(then)}, otherwise_{std::move(otherwise)} {}

    Term at(const Term& offset) const override {
        return choose(condition_, then_->read(offset, 1), otherwise_->read(offset, 1));
    }

  private:
    Term condition_;
    ContentsPointer then_;
    ContentsPointer otherwise_;
};

}  // namespace

Term LayeredContents::read(const Term& offset, unsigned bytes, const Reach& /*reach*/) const {
    Term word = at(offset);
    for (unsigned byte = 1; byte < bytes; ++byte) {
        word = z3::concat(at(plus(offset, byte)), word);
    }
    return word.simplify();
}

ContentsPointer LayeredContents::written(const Term& offset, const Term& word, const Reach& /*reach*/) const {
    return std::make_shared<Written>(shared_from_this(), offset, word);
}

ContentsPointer LayeredContents::copied(const Term& offset, const ContentsPointer& source, const Term& from,
                                        const Term& count, const Reach& /*reach*/) const {
    return std::make_shared<Copied>(shared_from_this(), offset, source, from, count);
}

ContentsPointer LayeredContents::merged(const Term& condition, const ContentsPointer& otherwise) const {
    return std::make_shared<Merged>(condition, shared_from_this(), otherwise);
}

Term UnknownBytes::at(const Term& offset) const {
    for (const AskedByte& one : asked_) {
        if (same(one.offset, offset)) {
            return one.value;
        }
    }
    const Term value = fresh_(byte_width);
    know_(this, offset, value);
    asked_.push_back({offset, value});
    return value;
}

}  // namespace canproof::host::prove
