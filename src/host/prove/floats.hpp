// SPDX-License-Identifier: Apache-2.0
// Arithmetic of IEEE 754 on bit vectors: float and double, rounded to nearest, ties to even. z3 writes each operation
// as a circuit of bit operations once; the operands replace the inputs of the circuit.
#pragma once

#include <llvm/IR/Instructions.h>
#include <llvm/IR/Intrinsics.h>

#include <functional>
#include <map>
#include <string>
#include <tuple>

#include "host/prove/arithmetic.hpp"
#include "host/prove/float_outline.hpp"
#include "host/prove/solver.hpp"

namespace canproof::host::prove {

class Floats {
  public:
    using MakeFresh = std::function<Term(unsigned width)>;

    /// `fresh` returns a new unknown. The sign and the payload of a result that is NaN are unknowns. The solver gets
    /// each sum, product and quotient as a definition.
    Floats(Solver& solver, MakeFresh fresh) : context_{solver.context()}, solver_{solver}, fresh_{std::move(fresh)} {}

    /// The functions below return nothing for a type or an operation that is not modelled. In a Computed, `defined` is
    /// false when the conversion to an integer has no result.
    std::optional<Term> computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b);
    Term negated(const Term& number) const;
    std::optional<Term> compared(const llvm::FCmpInst& comparison, const Term& a, const Term& b);
    std::optional<Computed> converted(const llvm::CastInst& cast, const Term& from);
    /// Computes an intrinsic of LLVM. `type` is the type of its first argument.
    std::optional<Term> computed(llvm::Intrinsic::ID function, const llvm::Type& type,
                                 const std::vector<Term>& arguments);

  private:
    /// An input of a circuit: its bits, and its value as a number of z3's theory of floating-point numbers.
    struct Number {
        Term bits;
        Term value;
    };
    using MakeTerm = std::function<Term(const std::vector<Number>& inputs)>;

    Number input(unsigned at, unsigned width) const;
    struct Applied {
        Term value;
        Term fails;  ///< true when the result is NaN
    };
    /// Returns the result of an operation on these operands. `make` writes the operation with z3's theory; its result
    /// is an integer or the bits of a number.
    Applied applied(const std::string& name, const std::vector<Term>& operands, const MakeTerm& make);
    /// Works as applied(), for an operation whose result is a number.
    Term number_of(const std::string& name, const std::vector<Term>& operands, unsigned width, const MakeTerm& make);
    /// Returns the result of an operation with a number as its result; a quiet NaN of any sign and payload when it
    /// fails.
    Term or_nan(const Applied& done, unsigned width);
    /// Returns the sum, product or quotient of two numbers.
    Term joined(FloatJoin join, const Term& a, const Term& b);
    /// Returns the unknown that is the name of this result, the same one each time.
    Term named(FloatJoin join, const Term& a, const Term& b, const Term& fails);
    /// Returns the bits of the result, as z3 computes them. They mean nothing when the result is NaN.
    Term circuit_of(FloatJoin join, const Term& a, const Term& b);
    /// Converts a number to another type.
    Term resized_number(const Term& from, unsigned width);
    /// Returns the double nearest to an integer of more than 53 bits.
    Term rounded_double(const Term& integer);
    std::optional<Term> of_integer(const Term& integer, unsigned width);
    Computed to_integer(const Term& from, unsigned bits, bool is_signed);
    /// Returns whether a number belongs to one of these classes of llvm.is.fpclass; each bit of `classes` is one class.
    Term is_of_class(const Term& number, std::uint64_t classes);

    z3::context& context_;
    Solver& solver_;
    MakeFresh fresh_;
    struct Circuit {
        z3::expr_vector inputs;
        Term fails;
        Term result;
    };
    std::map<std::string, Circuit> circuits_{};
    /// names of the results so far, by operation and by z3's numbers of the operands
    std::map<std::tuple<FloatJoin, unsigned, unsigned>, Term> names_{};
};

}  // namespace canproof::host::prove
