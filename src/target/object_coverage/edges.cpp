// SPDX-License-Identifier: Apache-2.0
// A plugin of QEMU (TCG) that records which blocks of instructions ran and which block ran after each. At the end it
// writes lines to the file of its argument `out=FILE`: `block FIRST LAST` and `edge LAST NEXT`, hexadecimal addresses
// of instructions.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "target/qemu/plugin.hpp"

namespace {

/// A block as QEMU translated it. `nexts` are the first instructions of the blocks that ran after it.
struct Block {
    std::uint64_t first;
    std::uint64_t last;
    bool ran{false};
    std::vector<std::uint64_t> nexts{};
};

/// The only object of this type is never destroyed, because QEMU calls ends() after the destructors of static
/// variables.
struct Record {
    std::vector<std::unique_ptr<Block>> blocks{};
    Block* before{nullptr};
    std::string out{};
};
Record& record = *new Record;

void runs(unsigned int, void* data) {
    auto* const block = static_cast<Block*>(data);
    block->ran = true;
    Block* const before = record.before;
    if (before != nullptr) {
        bool known = false;
        for (const std::uint64_t next : before->nexts) {
            known = known || next == block->first;
        }
        // A return has many successors and does not matter; a branch matters, and has at most two.
        if (!known && before->nexts.size() < 4) {
            before->nexts.push_back(block->first);
        }
    }
    record.before = block;
}

void translated(PluginId, qemu_plugin_tb* block) {
    const auto at = [block](std::size_t position) {
        return qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(block, position));
    };
    record.blocks.push_back(std::make_unique<Block>(Block{at(0), at(qemu_plugin_tb_n_insns(block) - 1)}));
    qemu_plugin_register_vcpu_tb_exec_cb(block, runs, no_registers, record.blocks.back().get());
}

void ends(PluginId, void*) {
    std::set<std::pair<std::uint64_t, std::uint64_t>> ran;
    std::set<std::pair<std::uint64_t, std::uint64_t>> edges;
    for (const auto& block : record.blocks) {
        if (block->ran) {
            ran.emplace(block->first, block->last);
        }
        for (const std::uint64_t next : block->nexts) {
            edges.emplace(block->last, next);
        }
    }
    std::FILE* const file = std::fopen(record.out.c_str(), "wb");
    if (file == nullptr) {
        std::fprintf(stderr, "cannot write %s\n", record.out.c_str());
        return;
    }
    bool written = true;
    for (const auto& [first, last] : ran) {
        written = std::fprintf(file, "block %llx %llx\n", static_cast<unsigned long long>(first),
                               static_cast<unsigned long long>(last)) > 0 &&
                  written;
    }
    for (const auto& [last, next] : edges) {
        written = std::fprintf(file, "edge %llx %llx\n", static_cast<unsigned long long>(last),
                               static_cast<unsigned long long>(next)) > 0 &&
                  written;
    }
    if (std::fclose(file) != 0 || !written) {
        std::fprintf(stderr, "cannot write %s\n", record.out.c_str());
    }
}

}  // namespace

int qemu_plugin_install(PluginId id, const void*, int count, char** arguments) {
    for (int i = 0; i < count; ++i) {
        if (std::strncmp(arguments[i], "out=", 4) == 0) {
            record.out = arguments[i] + 4;
        }
    }
    if (record.out.empty()) {
        std::fprintf(stderr, "edges: out=FILE is missing\n");
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, ends, nullptr);
    return 0;
}
