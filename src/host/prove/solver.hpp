// SPDX-License-Identifier: Apache-2.0
// Asks z3 questions and stores answers. The stored answers make most questions unnecessary.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>

#include "host/prove/assignment.hpp"

namespace canproof::host::prove {

enum class Answer { yes, no, unknown };
/// The part of definitions that z3 gets (Solver::define()): only their outlines, or the whole facts.
enum class Detail { outline, whole };

class Solver {
  public:
    explicit Solver(z3::context& context);

    /// Adds a fact that every later question assumes. z3 gets a fact only when a model (values for the unknowns) that
    /// z3 found contradicts it, so z3 gets few of the thousands of facts. This is sound: what is impossible without a
    /// fact is also impossible with it, and a model counts only if it contradicts no fact.
    void know(const Term& fact) { facts_.push_back(fact); }
    /// Adds the fact that `memory` contains the byte `value` at `offset`; equal offsets have equal bytes. `value` is a
    /// new unknown. z3 gets this fact, too, only when a model contradicts it.
    void know_byte(const void* memory, const Term& offset, const Term& value) {
        bytes_.push_back({memory, offset, value, definitions_.size()});
    }
    /// An unknown that stands for the result of an operation on two terms.
    struct Definition {
        Term name;
        Term a;
        Term b;
        std::function<Bits(Bits a, Bits b)> result;
        Term outline;                ///< a simple fact about name, a and b
        std::function<Term()> fact;  ///< makes the whole fact, which says that the name has the result as its value
        unsigned given{0};           ///< part that z3 has: nothing (0), the outline (1), the fact too (2)
    };
    /// Adds a definition, whose name no term contains yet. z3 gets the outline when a model contradicts the definition,
    /// and the fact when a model contradicts it again. So z3 sees a product of two numbers only where a proof depends
    /// on it.
    void define(Definition definition) { definitions_.push_back(std::move(definition)); }
    /// Returns whether all conditions of a path and `condition` can be true at the same time. Returns `unknown` when z3
    /// needs more than `milliseconds`.
    /// It also returns `unknown` when the answer depends on more than `detail` of the definitions.
    Answer satisfiable(const std::vector<Term>& path, const Term& condition, unsigned milliseconds,
                       Detail detail = Detail::whole);
    Answer satisfiable(const std::vector<Term>& path, unsigned milliseconds) {
        return satisfiable(path, context_.bool_val(true), milliseconds);
    }
    NodeId node_of(const Term& term) { return graph_.node_of(term); }
    /// Returns the values for which all conditions of the last question with the answer `yes` are true.
    Assignment& model() { return models_.front().values; }
    z3::context& context() const { return context_; }
    std::size_t questions() const { return questions_; }

  private:
    struct KnownByte {
        const void* memory;
        Term offset;
        Term value;
        std::size_t definitions;  ///< number of definitions that are older than this byte
    };
    /// Two bytes of the same memory that contradict each other, by their numbers in `bytes_`.
    struct Clash {
        std::size_t first;
        std::size_t second;
    };
    /// The values of an earlier answer. They are already compared with the first `met` facts and the first `placed`
    /// known bytes, and have the first `defined` definitions.
    struct Model {
        Assignment values;
        std::size_t met{0};
        std::size_t placed{0};
        std::size_t defined{0};
        bool keeps_facts{true};
        std::map<std::pair<const void*, Bits>, std::size_t> bytes{};  ///< number of the first known byte at each offset
                                                                      ///< of a memory
        /// bytes whose value from z3 differs from that of the first byte at their offset
        std::vector<Clash> clashes{};
        /// definitions whose name has another value in z3's model, by their numbers in `definitions_`
        std::vector<std::size_t> differing{};
    };

    /// Gives the names of the first `count` definitions their values in the model.
    void set_defined(Model& model, std::size_t count) const;
    /// Compares the model with each byte that became known after the model's last use. A byte at the offset of an
    /// earlier one gets that byte's value. Does the same with the definitions, in the order in which both were added,
    /// because the offset of a byte may depend on a definition, and a definition on a byte.
    void place_bytes(Model& model) const;
    /// Checks the facts that were added after the model was last checked. Returns false when the model contradicts one
    /// of them.
    bool keeps_facts(Model& model) const;
    bool fulfils(Model& model, const std::vector<Term>& truths) const;
    /// Returns the position of a stored model that makes all of `truths` and all facts true. If there is one, z3 need
    /// not be asked.
    std::optional<std::size_t> model_of(const std::vector<Term>& truths);
    /// Moves the model at this position to the front.
    void use(std::size_t place);
    void keep(Model model);
    /// The part of a path that matters for a condition: the conditions and facts that share unknowns with it, directly
    /// or through others. The rest of the path does not restrict these unknowns.
    struct Slice {
        std::vector<Term> truths;
        std::vector<NodeId> unknowns;
    };
    Slice slice_of(const std::vector<Term>& path, const Term& condition);
    /// Asks z3 only about the slice of the last of `truths`. If z3 finds a model of the slice, completes it with the
    /// values of a stored model of the path (number `model_of_path`).
    Answer ask_slice(const std::vector<Term>& truths, std::size_t model_of_path, unsigned milliseconds);
    /// Asks this solver of z3 again until its model contradicts no fact; adds the facts that the model contradicts
    /// before each new question.
    template <typename Check>
    Answer ask(z3::solver& solver, const std::vector<Term>& truths, const Check& check);
    Answer ask_kept(const std::vector<Term>& truths, unsigned milliseconds);
    Answer ask_anew(const std::vector<Term>& truths, unsigned milliseconds);
    /// Returns the facts that this model contradicts and that z3 does not have yet.
    std::vector<Term> missing_facts(Model& model, const std::vector<Term>& truths);
    /// Returns what z3 gets next of the definitions that this model contradicts and whose names are `reached`.
    std::vector<Term> missing_definitions(const Model& model, const std::set<NodeId>& reached);
    Term literal_of(const Term& truth);

    z3::context& context_;
    TermGraph graph_;
    std::vector<Term> facts_;
    std::vector<KnownByte> bytes_;
    std::vector<Definition> definitions_;
    Detail detail_{Detail::whole};     ///< the part that the present question may give to z3
    std::vector<Term> needed_;         ///< the facts that z3 gets
    std::set<std::size_t> is_needed_;  ///< positions in `facts_` of the facts that z3 gets
    std::deque<Model> models_;         ///< the model that was used last comes first
    std::size_t questions_{0};
    z3::solver kept_;          ///< z3 solver that keeps what it has learnt from one question to the next
    std::size_t kept_has_{0};  ///< number of the facts in `needed_` that `kept_` has
    std::unordered_map<unsigned, Term> literals_;
};

}  // namespace canproof::host::prove
