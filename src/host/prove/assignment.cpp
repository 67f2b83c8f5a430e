// SPDX-License-Identifier: Apache-2.0
#include "host/prove/assignment.hpp"

namespace canproof::host::prove {

namespace {

__extension__ using SignedBits = __int128;
constexpr unsigned widest = 128;

Bits cut(Bits value, unsigned width) {
    return width >= widest ? value : value & ((Bits{1} << width) - 1);
}

SignedBits as_signed(Bits value, unsigned width) {
    const unsigned unused = widest - width;
    return static_cast<SignedBits>(value << unused) >> unused;
}

Bits truth(bool holds) {
    return holds ? 1 : 0;
}

Bits shifted(Z3_decl_kind kind, Bits value, Bits by, unsigned width) {
    if (kind == Z3_OP_BASHR) {
        const SignedBits wide = as_signed(value, width);
        return cut(static_cast<Bits>(wide >> static_cast<unsigned>(by < width ? by : width - 1)), width);
    }
    if (by >= width) {
        return 0;
    }
    return cut(kind == Z3_OP_BSHL ? value << static_cast<unsigned>(by) : value >> static_cast<unsigned>(by), width);
}

}  // namespace

Assignment::Assignment(TermGraph& graph, const z3::model& model) : graph_{&graph} {
    for (unsigned i = 0; i < model.num_consts(); ++i) {
        const z3::func_decl unknown = model.get_const_decl(i);
        take(graph.node_of(unknown()), model, unknown);
    }
}

Assignment::Assignment(const Assignment& others, const z3::model& model, const std::vector<NodeId>& unknowns)
    : graph_{others.graph_}, unknowns_{others.unknowns_} {
    for (const NodeId unknown : unknowns) {
        const z3::context& context = model.ctx();
        take(unknown, model, {model.ctx(), Z3_get_app_decl(context, graph_->term_of(unknown))});
    }
    for (const auto& [unknown, value] : unknowns_) {
        put(unknown, value);
    }
}

void Assignment::take(NodeId unknown, const z3::model& model, const z3::func_decl& declared) {
    Bits value = 0;
    if (model.has_interp(declared)) {
        const Node& number = (*graph_)[graph_->node_of(model.get_const_interp(declared))];
        value = number.kind == Z3_OP_TRUE ? Bits{1} : number.value;
    }
    unknowns_[unknown] = value;
    put(unknown, value);
}

void Assignment::put(NodeId id, Bits value) {
    if (id >= values_.size()) {
        values_.resize(graph_->size());
        known_.resize(graph_->size());
    }
    values_[id] = value;
    known_[id] = true;
}

void Assignment::set(const Term& unknown, Bits value) {
    unknowns_[graph_->node_of(unknown)] = value;
    put(graph_->node_of(unknown), value);
}

std::optional<Bits> Assignment::of(const Term& term) {
    const NodeId wanted = graph_->node_of(term);
    if (!(*graph_)[wanted].supported) {
        return by_z3(wanted, term);
    }
    open_.assign(1, wanted);
    while (!open_.empty()) {
        const NodeId id = open_.back();
        if (is_known(id)) {
            open_.pop_back();
            continue;
        }
        const Node& node = (*graph_)[id];
        const std::size_t before = open_.size();
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const NodeId argument = graph_->argument(node, i);
            if (!is_known(argument)) {
                open_.push_back(argument);
                if (node.kind == Z3_OP_ITE && i == 0) {
                    break;  // only the side that the condition chooses needs a value
                }
            } else if (node.kind == Z3_OP_ITE && i == 0) {
                const NodeId side = graph_->argument(node, values_[argument] != 0 ? 1 : 2);
                if (!is_known(side)) {
                    open_.push_back(side);
                }
                break;
            }
        }
        if (open_.size() == before) {
            put(id, computed(node));
            open_.pop_back();
        }
    }
    return values_[wanted];
}

std::optional<Bits> Assignment::by_z3(NodeId wanted, const Term& term) {
    if (is_known(wanted)) {
        return values_[wanted];
    }
    z3::context& context = term.ctx();
    z3::expr_vector unknowns{context};
    z3::expr_vector values{context};
    for (const NodeId id : graph_->unknowns_of(term)) {
        const Term unknown{context, Z3_app_to_ast(context, graph_->term_of(id))};
        const auto found = unknowns_.find(id);
        const auto value = static_cast<std::uint64_t>(found == unknowns_.end() ? 0 : found->second);
        unknowns.push_back(unknown);
        values.push_back(unknown.is_bool() ? context.bool_val(value != 0)
                                           : resized(constant(context, value, 64), width_of(unknown)));
    }
    Term open = term;
    const Term closed = open.substitute(unknowns, values).simplify();
    const auto bits = closed.is_bool() ? std::nullopt : number(closed);
    if (!bits && !is_true(closed) && !is_false(closed)) {
        return std::nullopt;
    }
    put(wanted, bits ? Bits{*bits} : truth(is_true(closed)));
    return values_[wanted];
}

Bits Assignment::compared(const Node& node) const {
    const Bits a = at(node, 0);
    const Bits b = at(node, 1);
    const unsigned width = (*graph_)[graph_->argument(node, 0)].width;
    switch (node.kind) {
        case Z3_OP_ULEQ:
            return truth(a <= b);
        case Z3_OP_UGEQ:
            return truth(a >= b);
        case Z3_OP_ULT:
            return truth(a < b);
        case Z3_OP_UGT:
            return truth(a > b);
        case Z3_OP_SLEQ:
            return truth(as_signed(a, width) <= as_signed(b, width));
        case Z3_OP_SGEQ:
            return truth(as_signed(a, width) >= as_signed(b, width));
        case Z3_OP_SLT:
            return truth(as_signed(a, width) < as_signed(b, width));
        default:
            return truth(as_signed(a, width) > as_signed(b, width));
    }
}

Bits Assignment::divided(const Node& node) const {
    const Bits a = at(node, 0);
    const Bits b = at(node, 1);
    const bool is_signed = node.kind == Z3_OP_BSDIV || node.kind == Z3_OP_BSDIV_I || node.kind == Z3_OP_BSREM ||
                           node.kind == Z3_OP_BSREM_I;
    const bool wants_rest = node.kind == Z3_OP_BUREM || node.kind == Z3_OP_BUREM_I || node.kind == Z3_OP_BSREM ||
                            node.kind == Z3_OP_BSREM_I;
    const SignedBits left = as_signed(a, node.width);
    const SignedBits right = as_signed(b, node.width);
    if (b == 0) {  // SMT-LIB defines the result of a division by 0
        return wants_rest ? a : cut(is_signed && left < 0 ? Bits{1} : ~Bits{0}, node.width);
    }
    if (!is_signed) {
        return wants_rest ? a % b : a / b;
    }
    if (right == -1) {
        return wants_rest ? 0 : cut(Bits{0} - a, node.width);
    }
    return cut(static_cast<Bits>(wants_rest ? left % right : left / right), node.width);
}

/// Returns the value of an operation that takes any number of arguments.
Bits Assignment::joined(const Node& node) const {
    Bits all = at(node, 0);
    for (std::uint32_t i = 1; i < node.count; ++i) {
        const Bits next = at(node, i);
        switch (node.kind) {
            case Z3_OP_BADD:
                all += next;
                break;
            case Z3_OP_BSUB:
                all -= next;
                break;
            case Z3_OP_BMUL:
                all *= next;
                break;
            case Z3_OP_AND:
            case Z3_OP_BAND:
                all &= next;
                break;
            case Z3_OP_OR:
            case Z3_OP_BOR:
                all |= next;
                break;
            case Z3_OP_CONCAT:
                all = (all << (*graph_)[graph_->argument(node, i)].width) | next;
                break;
            default:
                all ^= next;
                break;
        }
    }
    return cut(all, node.width);
}

Bits Assignment::computed(const Node& node) const {
    switch (node.kind) {
        case Z3_OP_TRUE:
            return 1;
        case Z3_OP_FALSE:
        case Z3_OP_UNINTERPRETED:  // an unknown that the model does not name is 0
            return 0;
        case Z3_OP_BNUM:
            return node.value;
        case Z3_OP_EQ:
        case Z3_OP_IFF:
            return truth(at(node, 0) == at(node, 1));
        case Z3_OP_DISTINCT: {
            bool differ = true;
            for (std::uint32_t i = 0; i < node.count; ++i) {
                for (std::uint32_t j = 0; j < i; ++j) {
                    differ = differ && at(node, i) != at(node, j);
                }
            }
            return truth(differ);
        }
        case Z3_OP_ITE:
            return at(node, at(node, 0) != 0 ? 1 : 2);
        case Z3_OP_NOT:
            return at(node, 0) ^ 1U;
        case Z3_OP_IMPLIES:
            return truth(at(node, 0) == 0 || at(node, 1) != 0);
        case Z3_OP_BNEG:
            return cut(Bits{0} - at(node, 0), node.width);
        case Z3_OP_BNOT:
            return cut(~at(node, 0), node.width);
        case Z3_OP_BUDIV:
        case Z3_OP_BUREM:
        case Z3_OP_BUDIV_I:
        case Z3_OP_BUREM_I:
        case Z3_OP_BSDIV:
        case Z3_OP_BSREM:
        case Z3_OP_BSDIV_I:
        case Z3_OP_BSREM_I:
            return divided(node);
        case Z3_OP_ULEQ:
        case Z3_OP_SLEQ:
        case Z3_OP_UGEQ:
        case Z3_OP_SGEQ:
        case Z3_OP_ULT:
        case Z3_OP_SLT:
        case Z3_OP_UGT:
        case Z3_OP_SGT:
            return compared(node);
        case Z3_OP_SIGN_EXT:
            return cut(static_cast<Bits>(as_signed(at(node, 0), (*graph_)[graph_->argument(node, 0)].width)),
                       node.width);
        case Z3_OP_ZERO_EXT:
            return at(node, 0);
        case Z3_OP_EXTRACT:
            return cut(at(node, 0) >> node.low, node.width);
        case Z3_OP_REPEAT: {
            Bits all = 0;
            for (unsigned i = 0; i < node.high; ++i) {
                all = (all << (*graph_)[graph_->argument(node, 0)].width) | at(node, 0);
            }
            return all;
        }
        case Z3_OP_BSHL:
        case Z3_OP_BLSHR:
        case Z3_OP_BASHR:
            return shifted(node.kind, at(node, 0), at(node, 1), node.width);
        default:
            return joined(node);
    }
}

}  // namespace canproof::host::prove
