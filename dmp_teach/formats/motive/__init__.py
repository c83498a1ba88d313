"""Motion capture as Motive exports it."""
