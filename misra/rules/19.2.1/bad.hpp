int now();  // flagged
