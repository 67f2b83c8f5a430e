// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
namespace own {
int count{0};  // flagged
}
struct Row {
    static int total;  // flagged
};
