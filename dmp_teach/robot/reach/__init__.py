"""Which pages the arm can write on."""
