"""Words and lines on one clock."""
