// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int work();
using Work = int (*)();
Work choose() { return &work; }
int call() { return work(); }
