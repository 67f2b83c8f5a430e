// SPDX-License-Identifier: Apache-2.0
// The values of the unknowns in one answer of z3, and the values of all terms that depend on them.
#pragma once

#include "host/prove/term_graph.hpp"

namespace canproof::host::prove {

class Assignment {
  public:
    /// Takes the values of the unknowns from a model of z3. An unknown that the model does not name is 0.
    Assignment(TermGraph& graph, const z3::model& model);
    /// Takes the values of `unknowns` from a model of z3, and the values of all other unknowns from `others`.
    Assignment(const Assignment& others, const z3::model& model, const std::vector<NodeId>& unknowns);

    /// Returns the value of a term. z3 evaluates a term with more than 128 bits, and one with an operation that this
    /// class does not support. Returns nothing when z3 finds no value for the term.
    std::optional<Bits> of(const Term& term);
    bool makes_true(const Term& truth) { return of(truth) == Bits{1}; }
    /// Gives another value to an unknown. This is allowed only before a term that depends on the unknown is evaluated.
    void set(const Term& unknown, Bits value);

  private:
    bool is_known(NodeId id) const { return id < known_.size() && known_[id]; }
    void put(NodeId id, Bits value);
    void take(NodeId unknown, const z3::model& model, const z3::func_decl& declared);
    /// Lets z3 evaluate a term. `wanted` is the term's node.
    std::optional<Bits> by_z3(NodeId wanted, const Term& term);
    /// Returns the value of a node whose arguments have values.
    Bits computed(const Node& node) const;
    Bits at(const Node& node, std::uint32_t argument) const { return values_[graph_->argument(node, argument)]; }
    Bits compared(const Node& node) const;
    Bits divided(const Node& node) const;
    Bits joined(const Node& node) const;

    TermGraph* graph_;
    std::vector<Bits> values_;
    std::vector<bool> known_;
    std::vector<NodeId> open_;
    std::unordered_map<NodeId, Bits> unknowns_;  ///< values of the unknowns, which come from models and set()
};

}  // namespace canproof::host::prove
