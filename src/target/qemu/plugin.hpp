// SPDX-License-Identifier: Apache-2.0
// The functions of QEMU's plugin interface (TCG) that the plugins of this repository need. Debian ships no header of
// this interface.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {
// QEMU's plugin interface, version 1, as QEMU 7.2 documents it.
struct qemu_plugin_tb;
struct qemu_plugin_insn;
using PluginId = std::uint64_t;
enum CallbackFlags { no_registers };
void qemu_plugin_register_vcpu_tb_trans_cb(PluginId id, void (*translated)(PluginId id, qemu_plugin_tb* block));
void qemu_plugin_register_vcpu_tb_exec_cb(qemu_plugin_tb* block, void (*runs)(unsigned int cpu, void* data),
                                          CallbackFlags flags, void* data);
void qemu_plugin_register_atexit_cb(PluginId id, void (*ends)(PluginId id, void* data), void* data);
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* block);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb* block, std::size_t position);
std::uint64_t qemu_plugin_insn_vaddr(const qemu_plugin_insn* instruction);

extern const int qemu_plugin_version;
const int qemu_plugin_version = 1;
int qemu_plugin_install(PluginId id, const void* info, int count, char** arguments);
}
