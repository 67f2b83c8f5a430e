// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Queue {
    bool empty() const;
};
bool ready(const bool open, const Queue& queue, const int count) { return open && !queue.empty() && (count > 3); }
