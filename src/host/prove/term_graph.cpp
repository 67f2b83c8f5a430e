// SPDX-License-Identifier: Apache-2.0
#include "host/prove/term_graph.hpp"

#include <string>

namespace canproof::host::prove {

namespace {

constexpr unsigned most_bits = 128;

bool is_evaluated(Z3_decl_kind kind) {
    switch (kind) {
        case Z3_OP_TRUE:
        case Z3_OP_FALSE:
        case Z3_OP_EQ:
        case Z3_OP_DISTINCT:
        case Z3_OP_ITE:
        case Z3_OP_AND:
        case Z3_OP_OR:
        case Z3_OP_IFF:
        case Z3_OP_XOR:
        case Z3_OP_NOT:
        case Z3_OP_IMPLIES:
        case Z3_OP_BNUM:
        case Z3_OP_BNEG:
        case Z3_OP_BADD:
        case Z3_OP_BSUB:
        case Z3_OP_BMUL:
        case Z3_OP_BUDIV:
        case Z3_OP_BUREM:
        case Z3_OP_BUDIV_I:
        case Z3_OP_BUREM_I:
        case Z3_OP_BSDIV:
        case Z3_OP_BSREM:
        case Z3_OP_BSDIV_I:
        case Z3_OP_BSREM_I:
        case Z3_OP_ULEQ:
        case Z3_OP_SLEQ:
        case Z3_OP_UGEQ:
        case Z3_OP_SGEQ:
        case Z3_OP_ULT:
        case Z3_OP_SLT:
        case Z3_OP_UGT:
        case Z3_OP_SGT:
        case Z3_OP_BAND:
        case Z3_OP_BOR:
        case Z3_OP_BNOT:
        case Z3_OP_BXOR:
        case Z3_OP_CONCAT:
        case Z3_OP_SIGN_EXT:
        case Z3_OP_ZERO_EXT:
        case Z3_OP_EXTRACT:
        case Z3_OP_REPEAT:
        case Z3_OP_BSHL:
        case Z3_OP_BLSHR:
        case Z3_OP_BASHR:
        case Z3_OP_UNINTERPRETED:
            return true;
        default:
            return false;
    }
}

Bits number_in(const std::string& decimal) {
    Bits value = 0;
    for (const char digit : decimal) {
        value = value * 10U + static_cast<Bits>(digit - '0');
    }
    return value;
}

}  // namespace

NodeId TermGraph::add(Z3_app app) {
    const Z3_ast ast = Z3_app_to_ast(context_, app);
    const Z3_func_decl declared = Z3_get_app_decl(context_, app);
    const Z3_sort sort = Z3_get_sort(context_, ast);
    Node node;
    node.kind = Z3_get_decl_kind(context_, declared);
    node.width = Z3_get_sort_kind(context_, sort) == Z3_BV_SORT ? Z3_get_bv_sort_size(context_, sort) : 1U;
    node.first = static_cast<std::uint32_t>(arguments_.size());
    node.count = Z3_get_app_num_args(context_, app);
    node.supported =
        is_evaluated(node.kind) && node.width <= most_bits && (node.kind != Z3_OP_UNINTERPRETED || node.count == 0);
    for (std::uint32_t i = 0; i < node.count; ++i) {
        const unsigned id = Z3_get_ast_id(context_, Z3_get_app_arg(context_, app, i));
        arguments_.push_back(known_.at(id));
        node.supported = node.supported && nodes_[arguments_.back()].supported;
    }
    if (node.kind == Z3_OP_BNUM) {
        node.supported = node.width <= most_bits;
        std::uint64_t small = 0;
        node.value = Z3_get_numeral_uint64(context_, ast, &small) ? Bits{small}
                                                                  : number_in(Z3_get_numeral_string(context_, ast));
    } else if (node.kind == Z3_OP_EXTRACT) {
        node.high = static_cast<unsigned>(Z3_get_decl_int_parameter(context_, declared, 0));
        node.low = static_cast<unsigned>(Z3_get_decl_int_parameter(context_, declared, 1));
    } else if (node.kind == Z3_OP_REPEAT) {
        node.high = static_cast<unsigned>(Z3_get_decl_int_parameter(context_, declared, 0));
    }
    if (node.kind == Z3_OP_UNINTERPRETED) {
        terms_.emplace(static_cast<NodeId>(nodes_.size()), app);
    }
    nodes_.push_back(node);
    return static_cast<NodeId>(nodes_.size() - 1);
}

NodeId TermGraph::node_of(const Term& term) {
    const auto found = known_.find(term.id());
    if (found != known_.end()) {
        return found->second;
    }
    kept_.push_back(term);
    std::vector<Z3_app> open{Z3_to_app(context_, term)};
    while (!open.empty()) {
        const Z3_app app = open.back();
        const unsigned id = Z3_get_ast_id(context_, Z3_app_to_ast(context_, app));
        if (known_.find(id) != known_.end()) {
            open.pop_back();
            continue;
        }
        bool is_ready = true;
        for (unsigned i = 0; i < Z3_get_app_num_args(context_, app); ++i) {
            const Z3_ast argument = Z3_get_app_arg(context_, app, i);
            if (known_.find(Z3_get_ast_id(context_, argument)) == known_.end()) {
                open.push_back(Z3_to_app(context_, argument));
                is_ready = false;
            }
        }
        if (is_ready) {
            open.pop_back();
            known_[id] = add(app);
        }
    }
    return known_.at(term.id());
}

const std::vector<NodeId>& TermGraph::unknowns_of(const Term& term) {
    const NodeId root = node_of(term);
    const auto [found, is_new] = unknowns_.try_emplace(root);
    if (!is_new) {
        return found->second;
    }
    ++searches_;
    seen_.resize(nodes_.size(), 0);
    std::vector<NodeId> open{root};
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        if (seen_[id] == searches_) {
            continue;
        }
        seen_[id] = searches_;
        if (nodes_[id].kind == Z3_OP_UNINTERPRETED) {
            found->second.push_back(id);
        }
        for (std::uint32_t i = 0; i < nodes_[id].count; ++i) {
            open.push_back(argument(nodes_[id], i));
        }
    }
    return found->second;
}

}  // namespace canproof::host::prove
