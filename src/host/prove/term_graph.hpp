// SPDX-License-Identifier: Apache-2.0
// The terms of z3 as nodes of the prover's own graph. Equal terms are one node, and each node comes after its
// arguments. So a term is evaluated without calls of z3, and a part that several terms share is evaluated once.
#pragma once

#include <unordered_map>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// A value of up to 128 bits.
__extension__ using Bits = unsigned __int128;

/// The index of a node in a TermGraph.
using NodeId = std::uint32_t;

struct Node {
    Z3_decl_kind kind{Z3_OP_TRUE};
    bool supported{false};   ///< whether Assignment can evaluate this operation and its arguments without z3
    unsigned width{1};       ///< number of bits; 1 for a truth value
    std::uint32_t first{0};  ///< position of the first argument in the list `arguments_`
    std::uint32_t count{0};  ///< number of arguments
    unsigned high{0};        ///< `high` of extract(high, low), or the count of an extension or repetition
    unsigned low{0};
    Bits value{0};  ///< value of a constant
};

class TermGraph {
  public:
    explicit TermGraph(z3::context& context) : context_{context}, kept_{context} {}

    /// Returns the node of a term. Makes this node and the nodes of the term's arguments if they do not exist yet.
    NodeId node_of(const Term& term);
    const Node& operator[](NodeId id) const { return nodes_[id]; }
    NodeId argument(const Node& node, std::uint32_t at) const { return arguments_[node.first + at]; }
    std::size_t size() const { return nodes_.size(); }
    /// Returns the unknowns on which a term depends.
    const std::vector<NodeId>& unknowns_of(const Term& term);
    /// Returns z3's term of an unknown, by its node.
    Z3_app term_of(NodeId unknown) const { return terms_.at(unknown); }

  private:
    NodeId add(Z3_app app);

    z3::context& context_;
    z3::expr_vector kept_;  ///< keeps the terms alive, so that z3 gives their numbers to no other terms
    std::unordered_map<unsigned, NodeId> known_;  ///< node by z3's number of the term
    std::vector<Node> nodes_;
    std::vector<NodeId> arguments_;
    std::unordered_map<NodeId, Z3_app> terms_;  ///< the unknowns
    std::unordered_map<NodeId, std::vector<NodeId>> unknowns_;
    std::vector<unsigned> seen_;  ///< for each node, the number of the last search that reached it
    unsigned searches_{0};
};

}  // namespace canproof::host::prove
