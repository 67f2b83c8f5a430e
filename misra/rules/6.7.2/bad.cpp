// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
namespace own {
int count{0};  // flagged
}
struct Row {
    static int total;  // flagged
};
