"""The frame of every lesson: bet, try, challenge; knobs, checks, and the panel that shows them."""
