// Nothing here may be flagged.
int work() noexcept;
int main() { return work(); }
