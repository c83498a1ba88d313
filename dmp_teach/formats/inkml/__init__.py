"""Digital ink as the W3C's InkML has it."""
