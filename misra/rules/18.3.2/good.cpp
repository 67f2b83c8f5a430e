// Nothing here may be flagged.
int work() noexcept;
int safe() { return work(); }
