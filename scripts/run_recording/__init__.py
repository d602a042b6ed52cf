"""Recording of runs: where they are kept, which topics they hold, the process that writes them, and the load of the nodes."""
