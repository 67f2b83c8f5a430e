# SPDX-License-Identifier: Apache-2.0
# These sources define names that other sources of this folder define too; so src/host/join.cmake compiles each file
# separately.
set(apart receive_pdo_faults.cpp sdo_frame_faults.cpp sdo_transfer_faults.cpp sync_faults.cpp transmit_pdo_faults.cpp)
